#include "fit/grey_levels.h"

#include <cmath>

#include <gtest/gtest.h>

#include "synth/forged.h"

namespace hada {
namespace {

Grid<float> grain(double levels, double step) {
  auto block = forged_block({.sequence = "CRCR"}, {512, 512}, 3);
  quantise(block, levels, step);
  return block;
}

TEST(GreyLevels, AreThoseOfAnUntouchedBlock) {
  const auto levels = grey_levels(grain(70.0, 5.0), 4);
  // Whole numbers on a comb: the step is exact but for the parabola through the line.
  EXPECT_NEAR(levels.step, 5.0, 0.01);
  EXPECT_NEAR(levels.highest, 70.0, 0.2);
}

TEST(GreyLevels, AreSeenThroughNoise) {
  auto noisy = grain(120.0, 8.0);
  for (int row = 0; row < noisy.rows(); ++row) {
    for (int col = 0; col < noisy.cols(); ++col)
      noisy(row, col) = std::round(noisy(row, col) + float(1.2 * gaussian(4, row, col)));
  }
  const auto levels = grey_levels(noisy, 4);
  EXPECT_NEAR(levels.step, 8.0, 5.0 * levels.step_sigma + 0.01);
  EXPECT_NEAR(levels.highest, 120.0, 3.0 * levels.highest_sigma);
}

TEST(GreyLevels, AreNotSeenWhereThereAreNone) {
  EXPECT_EQ(grey_levels(grain(200.0, 0.0), 4).step, 0.0);
}

}  // namespace
}  // namespace hada
