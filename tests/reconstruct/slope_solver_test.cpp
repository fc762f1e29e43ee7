#include "reconstruct/slope_solver.h"

#include <gtest/gtest.h>

#include "scenes.h"

namespace hada {
namespace {

TEST(SlopeSolver, IsLinearInTheSlopes) {
  const Mask mask = torn_mask(40, 50, 1);
  SlopeMap slopes = slopes_of(waves(40, 50).normals, mask);
  SlopeSolver solver(mask);
  const auto height = solver.height(slopes, 1e-9, 500);
  for (auto& slope : slopes) slope *= 2.0f;
  const auto twice = solver.height(slopes, 1e-9, 500);
  for (std::size_t i = 0; i < height.size(); ++i) ASSERT_NEAR(twice[i], 2.0f * height[i], 1e-5f);
}

TEST(SlopeSolver, SettlesInAFewIterationsAtAnySize) {
  // A plain conjugate gradient needs in the order of one iteration per pixel of the width.
  for (const int size : {64, 256}) {
    const Relief relief = waves(size, size);
    const Mask mask = full_mask(relief.extent);
    const SlopeMap slopes = slopes_of(relief.normals, mask);
    SlopeSolver solver(mask);
    const auto settled = solver.height(slopes, 1e-10, 500);
    EXPECT_LT(rms_difference(solver.height(slopes, 0.0, 25), settled, mask), 1e-5);
  }
}

}  // namespace
}  // namespace hada
