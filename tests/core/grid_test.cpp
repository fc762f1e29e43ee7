#include "core/grid.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

Grid<int> numbered(int rows, int cols) {
  Grid<int> grid(rows, cols);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) grid(row, col) = 10 * row + col;
  }
  return grid;
}

TEST(Grid, StoresRowsOneAfterAnother) {
  const Grid<int> grid = numbered(3, 4);
  EXPECT_EQ(grid.size(), 12u);
  EXPECT_EQ(grid[5], 11);
  EXPECT_EQ(grid.row(2)[3], 23);
  EXPECT_EQ(grid.row(1).size(), 4u);
  EXPECT_TRUE(grid.contains(2, 3));
  EXPECT_FALSE(grid.contains(3, 0));
  EXPECT_FALSE(grid.contains(0, -1));
}

TEST(Grid, IsEmptyUntilItHasASize) {
  EXPECT_TRUE(Grid<float>().empty());
  EXPECT_TRUE(Grid<float>(0, 5).empty());
  EXPECT_EQ(Grid<float>(2, 2, 1.5f)(1, 1), 1.5f);
}

TEST(Grid, ShrinksInPlace) {
  Grid<int> grid = numbered(3, 4);
  const int* const before = grid.data();
  grid.shrink_to(2, 3);
  EXPECT_EQ(grid.size(), 6u);
  EXPECT_EQ(grid(1, 0), 3);
  EXPECT_EQ(grid(1, 1), 10);
  EXPECT_EQ(grid.data(), before);
}

TEST(Grid, CropsARectangle) {
  const Grid<int> part = crop(numbered(5, 6), 1, 2, 3, 2);
  EXPECT_EQ(part.rows(), 3);
  EXPECT_EQ(part.cols(), 2);
  EXPECT_EQ(part(0, 0), 12);
  EXPECT_EQ(part(2, 1), 33);
  EXPECT_EQ(crop(numbered(5, 6), 0, 0, 5, 6), numbered(5, 6));
}

}  // namespace
}  // namespace hada
