#include "reconstruct/edge_aware.h"

#include <vector>

#include <gtest/gtest.h>

#include "reconstruct/slope_solver.h"
#include "scenes.h"

namespace hada {
namespace {

TEST(EdgeAware, IsLeastSquaresWhereNothingJumps) {
  const Relief relief = waves(60, 70);
  const Mask mask = torn_mask(60, 70, 2);
  const SlopeMap slopes = slopes_of(relief.normals, mask);
  const auto found = edge_aware_height(slopes, facing_of(relief.normals, mask), mask);
  const auto smooth = SlopeSolver(mask).height(slopes, 1e-5, 100);
  // One-sided steps err by z'' / 2 where a side is preferred, up to 0.05 px here, and of both
  // signs.
  EXPECT_LT(rms_difference(found.height, smooth, mask), 0.1);
  EXPECT_GT(found.held_together, 0.98);
}

TEST(EdgeAware, KeepsAStepThatItsPixelsAgreeOn) {
  // Two slanted planes side by side; only their ends at the left meet.
  const Relief planes = relief_of(80, 80, [](double x, double y) {
    const double slope = y > 0.0 ? 0.8 : 0.0;
    return Eigen::Vector3d(slope * (x + 39.5), slope, 0.0);
  });
  const Mask mask(80, 80, 1);
  const auto found =
      edge_aware_height(slopes_of(planes.normals, mask), facing_of(planes.normals, mask), mask);
  const double inside_upper = found.height(10, 70) - found.height(10, 10);
  const double inside_lower = found.height(70, 70) - found.height(70, 10);
  EXPECT_NEAR(inside_upper, 0.8 * 60.0, 0.8);  // least squares, which bends both, is off by several
  EXPECT_NEAR(inside_lower, 0.0, 0.8);
}

TEST(EdgeAware, TellsOfEveryRound) {
  const Relief relief = waves(20, 20);
  const Mask mask(20, 20, 1);
  std::vector<int> told;
  edge_aware_height(
      slopes_of(relief.normals, mask), facing_of(relief.normals, mask), mask,
      {.max_rounds = 3, .least_change = 0.0, .done = [&](int rounds) { told.push_back(rounds); }});
  EXPECT_EQ(told, (std::vector<int>{1, 2, 3}));
}

TEST(EdgeAware, LetsPixelsCountAsTheyAreKnown) {
  // A step between two planes, and a patch whose slopes are wrong and known to be.
  const Relief planes = relief_of(80, 80, [](double x, double y) {
    const double slope = y > 0.0 ? 0.8 : 0.0;
    return Eigen::Vector3d(slope * (x + 39.5), slope, 0.0);
  });
  const Mask mask(80, 80, 1);
  NormalMap spoilt = planes.normals;
  Grid<float> weight(80, 80, 3.0f);
  Mask outside = mask;  // of the patch
  for (int row = 55; row < 70; ++row) {
    for (int col = 30; col < 45; ++col) {
      spoilt(row, col) = Eigen::Vector3f(-0.6f, 0.3f, 0.74f).normalized();
      weight(row, col) = 3e-4f;
      outside(row, col) = 0;
    }
  }
  const auto height = [&](const NormalMap& normals, const Grid<float>* of_pixels) {
    return edge_aware_height(slopes_of(normals, mask), facing_of(normals, mask), mask,
                             {.weight = of_pixels})
        .height;
  };
  const Grid<float> clean = height(planes.normals, nullptr);
  const double known = rms_difference(height(spoilt, &weight), clean, outside);
  const double unknown = rms_difference(height(spoilt, nullptr), clean, outside);
  EXPECT_LT(known, 0.8 * unknown);
  // Weights that are all alike say nothing, however large they are.
  const Grid<float> alike(80, 80, 50.0f);
  EXPECT_LT(rms_difference(height(planes.normals, &alike), clean, mask), 0.01);
}

TEST(EdgeAware, LiftsPartsThatAreCutOffToWhereASmoothHeightHasThem) {
  EdgeAware found;
  found.height = Grid<float>(2, 3);
  found.part = Grid<int>(2, 3);
  found.part_size = {0, 3, 2};  // the upper row; two of the lower, whose last is outside
  Grid<float> smooth(2, 3);
  for (int col = 0; col < 3; ++col) {
    found.height(0, col) = 5.0f + float(col);
    found.part(0, col) = 1;
    smooth(0, col) = 2.0f * float(col);
  }
  for (int col = 0; col < 2; ++col) {
    found.height(1, col) = -9.0f - 3.0f * float(col);
    found.part(1, col) = 2;
    smooth(1, col) = -3.0f;
  }
  place_parts(found, smooth);
  for (int col = 0; col < 3; ++col) EXPECT_FLOAT_EQ(found.height(0, col), 1.0f + float(col));
  for (int col = 0; col < 2; ++col)
    EXPECT_FLOAT_EQ(found.height(1, col), -1.5f - 3.0f * float(col));
  EXPECT_EQ(found.height(1, 2), 0.0f);
}

}  // namespace
}  // namespace hada
