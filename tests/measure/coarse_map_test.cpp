#include "measure/coarse_map.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

// A slope over 300 x 100 pixels at (20, 10): blocks of 3, whose means lie on the slope too.
TEST(CoarseMap, HoldsTheMeansOfBlocks) {
  Grid<float> map(330, 140, std::nanf(""));
  Mask mask(330, 140, 0);
  for (int row = 20; row < 320; ++row) {
    for (int col = 10; col < 110; ++col) {
      mask(row, col) = 1;
      map(row, col) = float(row - 2 * col);
    }
  }
  const CoarseMap coarse = coarse_map(map, mask, 0.5);
  EXPECT_EQ(coarse.block, 3);
  EXPECT_EQ(coarse.pitch, 1.5);
  EXPECT_EQ(coarse.box.row, 20);
  EXPECT_EQ(coarse.box.col, 10);
  // The last column of blocks has but one of three pixels inside.
  ASSERT_EQ(coarse.mask.rows(), 100);
  ASSERT_EQ(coarse.mask.cols(), 34);
  EXPECT_EQ(coarse.mask(50, 32), 1);
  EXPECT_EQ(coarse.mask(50, 33), 0);
  EXPECT_NEAR(coarse.height(51, 20) - coarse.height(50, 20), 3.0, 1e-9);
  EXPECT_NEAR(coarse.height(50, 21) - coarse.height(50, 20), -6.0, 1e-9);
  // Of 100 steps of 3 and 33 of 6: (n^2 - 1) / 12 each.
  EXPECT_NEAR(coarse.variance, (9.0 * 9999.0 + 36.0 * 1088.0) / 12.0, 1e-6);
}

TEST(CoarseMap, KeepsSixteenStepsOverTheShorterSide) {
  const CoarseMap coarse = coarse_map(Grid<float>(40, 4000), Mask(40, 4000, 1), 1.0);
  EXPECT_EQ(coarse.block, 2);
  EXPECT_EQ(coarse.mask.rows(), 20);
}

}  // namespace
}  // namespace hada
