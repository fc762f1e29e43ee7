#include "measure/small_holes.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

Grid<float> saddle(int rows, int cols) {
  Grid<float> map(rows, cols);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) map(row, col) = float(row * col) + 0.5f * float(row);
  }
  return map;
}

void cut(MaskedMap& from, int row, int col, int rows, int cols) {
  for (int r = row; r < row + rows; ++r) {
    for (int c = col; c < col + cols; ++c) {
      from.mask(r, c) = 0;
      from.map(r, c) = std::nanf("");
    }
  }
}

TEST(SmallHoles, AreFilledAsASoapFilmWouldBe) {
  // A saddle is the mean of its neighbours everywhere.
  const Grid<float> whole = saddle(20, 30);
  MaskedMap torn{whole, Mask(20, 30, 1)};
  cut(torn, 4, 5, 1, 1);
  cut(torn, 9, 12, 5, 4);
  const auto filled = without_small_holes(torn.map, torn.mask, 20);
  ASSERT_TRUE(filled);
  EXPECT_EQ(filled->map(4, 5), whole(4, 5));
  for (int row = 0; row < 20; ++row) {
    for (int col = 0; col < 30; ++col) {
      EXPECT_EQ(filled->mask(row, col), 1);
      // The last sweep moved by less than 1e-3 of the range round the hole, 117. The slowest error
      // is left by a sweep with a share of ((cos(pi / 6) + cos(pi / 5)) / 2)^2 = 0.70, so all to
      // come move by 0.70 / 0.30 times that.
      EXPECT_NEAR(filled->map(row, col), whole(row, col), 1e-3f * 117.0f * 0.70f / 0.30f);
    }
  }
}

TEST(SmallHoles, AreNoneAtASideNorLargeOnes) {
  MaskedMap torn{saddle(20, 30), Mask(20, 30, 1)};
  cut(torn, 0, 8, 2, 2);
  cut(torn, 19, 3, 1, 1);
  cut(torn, 6, 6, 3, 4);
  EXPECT_FALSE(without_small_holes(torn.map, torn.mask, 11));
  const auto filled = without_small_holes(torn.map, torn.mask, 12);
  ASSERT_TRUE(filled);
  EXPECT_EQ(filled->mask(7, 8), 1);
  EXPECT_EQ(filled->mask(1, 8), 0);
  EXPECT_TRUE(std::isnan(filled->map(1, 8)));
}

TEST(SmallHoles, OfAMaskOfNothingStay) {
  EXPECT_FALSE(without_small_holes(Grid<float>(5, 5), Mask(5, 5, 0), 100));
}

}  // namespace
}  // namespace hada
