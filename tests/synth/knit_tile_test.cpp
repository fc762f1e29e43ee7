#include "synth/knit_tile.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(KnitTile, IsOpaqueWhereYarnIsAndNotInItsHoles) {
  Knit<> knit;
  knit.wale_mm = 1.6, knit.course_mm = 1.3, knit.yarn_radius_mm = 0.18, knit.loop_depth_mm = 0.15;
  const Extent extent{128, 160, 0.1, Unit::mm};
  const Surface surface = surface_of(knit, extent, 1);
  const Grid<float> opacity = tile_opacity(knit, extent);
  double hidden = 0.0, all = 0.0, seam = 0.0, inside = 0.0;
  for (std::size_t k = 0; k < opacity.size(); ++k) {
    ASSERT_GE(opacity[k], 0.0f);
    ASSERT_LE(opacity[k], 1.0f);
    const bool yarn = surface.albedo.planes[0][k] > 0.0f;
    // The middle of a pixel is one of the nine places that are asked.
    EXPECT_TRUE(yarn ? opacity[k] > 0.0f : opacity[k] < 1.0f) << k;
    hidden += yarn, all += opacity[k];
  }
  EXPECT_NEAR(all / hidden, 1.0, 0.02);
  EXPECT_LT(all, 0.95 * double(opacity.size()));
  for (int row = 0; row < extent.rows; ++row) {
    seam += std::abs(opacity(row, 0) - opacity(row, extent.cols - 1));
    inside += std::abs(opacity(row, 80) - opacity(row, 79));
  }
  // It tiles: a seam between the same places of two stitches is as rough as any column.
  EXPECT_LT(seam, 2.0 * inside + 8.0);
}

TEST(KnitTile, HoldsWholeStitchesAndRepeats) {
  Knit<> knit;
  knit.wale_mm = 1.55, knit.course_mm = 1.2, knit.yarn_radius_mm = 0.2;
  knit.colour_repeat = {0.0, 1.0};
  const Extent extent{96, 124, 0.1, Unit::mm};
  // 12.4 mm hold 8 wales, 9.6 mm hold 8 courses: what is there comes again 8 times each way.
  const KnitMaps maps = tile_maps(knit, extent);
  int same = 0, all = 0;
  for (int row = 0; row < 96; ++row) {
    for (int col = 0; col < 124; ++col, ++all) {
      same += maps.course(row, col) == maps.course((row + 24) % 96, (col + 31) % 124);
    }
  }
  EXPECT_GT(same, 0.97 * all);  // two wales on and two courses down; edges fall between pixels
}

}  // namespace
}  // namespace hada
