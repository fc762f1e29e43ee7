#include "fit/unrolled.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "core/surface.h"

namespace hada {
namespace {

constexpr Extent extent{.rows = 200, .cols = 240, .pitch = 0.5, .unit = Unit::mm};
const GrowthFrame frame{{5.0, 2.0}, {{2.0, 0.04, 0.03}}};

/// Brightness is the effective radius, in mm.
Grid<float> radii() {
  Grid<float> map(extent.rows, extent.cols);
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col)
      map(row, col) = float(frame.rho_of(extent.place(row, col)));
  }
  return map;
}

TEST(Unrolled, LaysRingsFlat) {
  const auto flat = unrolled(radii(), full_mask(extent), extent, frame);
  EXPECT_TRUE(flat.whole_turn);
  ASSERT_EQ(flat.theta.size(), std::size_t(flat.values.rows()));
  // Between pixels a cone is 0.1 px too high at most beyond a few pixels from its tip.
  for (int s = 0; s < flat.values.rows(); ++s) {
    for (int col = 20; col < flat.values.cols(); ++col) {
      const float value = flat.values(s, col);
      if (!(value == value)) continue;
      EXPECT_NEAR(value, flat.rho(col), 0.1 * extent.pitch);
    }
  }
}

TEST(Unrolled, SeesPartOfATurnFromOutside) {
  GrowthFrame outside = frame;
  outside.pith = {-100.0, 0.0};
  const auto flat = unrolled(radii(), full_mask(extent), extent, outside);
  EXPECT_FALSE(flat.whole_turn);
  // The near side of the picture, 100 mm high, is 40 mm away.
  EXPECT_NEAR(flat.sector_rad * double(flat.theta.size()), 2.0 * std::atan2(50.0, 40.0), 0.1);
  EXPECT_GT(flat.first, 30.0);
}

TEST(Unrolled, IsAsQuietNearThePithAsAtTheRim) {
  Grid<float> noise(extent.rows, extent.cols);
  std::int64_t k = 0;
  for (float& value : noise) value = float(gaussian(7, k++));
  const auto flat = unrolled(noise, full_mask(extent), extent, {});
  const auto scatter = [&](int col) {
    double square = 0.0;
    for (int s = 0; s < flat.values.rows(); ++s)
      square += double(flat.values(s, col)) * flat.values(s, col) / flat.values.rows();
    return std::sqrt(square);
  };
  // 6 px from the pith a sector of 1/15 turn is 2.5 px wide: without its neighbours it would see
  // three pixels or four, whose median scatters by 0.55; 16 px of arc are six times that.
  EXPECT_LT(scatter(12), 0.35);
  EXPECT_LT(scatter(12), 2.0 * scatter(150));
}

TEST(Unrolled, DoesNotReadOutsideTheMask) {
  auto map = radii();
  Mask mask = full_mask(extent);
  for (int row = 0; row < 60; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      mask(row, col) = 0;
      map(row, col) = 1e9f;
    }
  }
  const auto flat = unrolled(map, mask, extent, frame);
  for (const float value : flat.values) EXPECT_FALSE(value > 1e3f);
  EXPECT_THROW(unrolled(map, Mask(extent.rows, extent.cols, 0), extent, frame), Error);
}

}  // namespace
}  // namespace hada
