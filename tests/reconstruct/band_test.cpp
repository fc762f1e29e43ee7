#include "reconstruct/band.h"

#include <cstring>

#include <gtest/gtest.h>

#include "scenes.h"

namespace hada {
namespace {

class Bands : public testing::Test {
 protected:
  NormalMaps solved(const std::vector<int>& ends, std::size_t& rows_told) const {
    NormalMaps maps(stack_, true);
    int begin = 0;
    for (const int end : ends) {
      rows_told += solve_band(source_, plan_, begin, end, true, maps).size();
      begin = end;
    }
    return maps;
  }

  const NormalOptions options_{.estimator = Estimator::biweight};
  const LightStack stack_ = pictures_of(waves(24, 30), ring_of_lights(8), {.noise = 0.002});
  const TileSource source_ = source_of(stack_, options_);
  const NormalPlan plan_ = plan_normals(source_, options_.estimator);
};

TEST_F(Bands, NeedNothingOfEachOther) {
  std::size_t whole_rows = 0, band_rows = 0;
  const NormalMaps whole = solved({24}, whole_rows), bands = solved({1, 9, 24}, band_rows);
  EXPECT_EQ(whole_rows, 24u);
  EXPECT_EQ(band_rows, 24u);
  const auto same = [](const auto& a, const auto& b) {
    return a.size() == b.size() && std::memcmp(&a[0], &b[0], a.size() * sizeof(a[0])) == 0;
  };
  EXPECT_TRUE(same(whole.orientation.normals, bands.orientation.normals));
  EXPECT_TRUE(same(whole.orientation.mask, bands.orientation.mask));
  EXPECT_TRUE(same(whole.noise_gain, bands.noise_gain));
  EXPECT_TRUE(same(whole.albedo_gain, bands.albedo_gain));
}

TEST_F(Bands, LeaveOtherRowsAlone) {
  const NormalMaps fresh(stack_, true);
  NormalMaps maps(stack_, true);
  solve_band(source_, plan_, 8, 16, true, maps);
  for (int row = 0; row < 24; ++row) {
    const bool solved = maps.orientation.normals(row, 3) != fresh.orientation.normals(row, 3);
    EXPECT_EQ(solved, row >= 8 && row < 16) << row;
  }
}

}  // namespace
}  // namespace hada
