#include "reconstruct/tile_source.h"

#include <gtest/gtest.h>

#include "reconstruct/normals.h"
#include "scenes.h"

namespace hada {
namespace {

constexpr int row = 4, first_col = 3, count = 5;

class Tiles : public testing::Test {
 protected:
  Tiles() {
    auto lights = ring_of_lights(5);
    for (std::size_t k = 0; k < lights.size(); ++k)
      lights[k].strength.setConstant(0.6 + 0.2 * double(k));
    stack_ = pictures_of(relief_, lights);
  }
  const Relief relief_ = waves(10, 12);
  LightStack stack_;
};

TEST_F(Tiles, HoldGreyValuesFreeOfTheStrengthOfLights) {
  const TileSource source = source_of(stack_, {.estimator = Estimator::trimmed});
  EXPECT_FALSE(source.near());
  Tile tile = source.tile(16, false);
  EXPECT_TRUE(source.fill(tile, 0, row, first_col, count));
  for (int k = 0; k < tile.lights; ++k) {
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3f normal = relief_.normals(row, first_col + i);
      const Eigen::Vector3f to = stack_.lights[std::size_t(k)].direction.normalized().cast<float>();
      // Pictures are floats; albedo 0.6.
      EXPECT_NEAR(tile.grey[tile.at(k, i)], 0.6f * normal.dot(to), 1e-6f);
      EXPECT_EQ(tile.trust[tile.at(k, i)], 1.0f);
    }
  }
}

TEST_F(Tiles, TrustNoSampleInShadowUnlessAllCount) {
  stack_.samples[2](row, first_col + 1) = Sample::shadowed;
  TileSource source = source_of(stack_, {.estimator = Estimator::trimmed});
  Tile tile = source.tile(16, false);
  EXPECT_FALSE(source.fill(tile, 0, row, first_col, count));
  EXPECT_EQ(tile.trust[tile.at(2, 1)], 0.0f);
  EXPECT_EQ(tile.trust[tile.at(2, 0)], 1.0f);
  source.all_count = true;
  EXPECT_TRUE(source.fill(tile, 0, row, first_col, count));
  EXPECT_EQ(tile.trust[tile.at(2, 1)], 1.0f);
}

TEST_F(Tiles, AgreeWithWhatIsReadDirectly) {
  const TileSource source = source_of(stack_, {.estimator = Estimator::trimmed});
  ASSERT_TRUE(source.reads_directly());
  Tile tile = source.tile(16, false);
  source.fill(tile, 0, row, first_col, count);
  GreyRows rows;
  source.point_at_row(row, first_col, rows);
  for (int k = 0; k < tile.lights; ++k) {
    for (int i = 0; i < count; ++i) {
      const float direct = rows.scale[std::size_t(k)] * rows.values[std::size_t(k)][i];
      EXPECT_NEAR(direct, tile.grey[tile.at(k, i)], 1e-6f);
    }
  }
}

}  // namespace
}  // namespace hada
