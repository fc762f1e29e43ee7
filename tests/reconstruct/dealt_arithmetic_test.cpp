#include "reconstruct/dealt_arithmetic.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace hada {
namespace {

// 10 row + col in every cell, dealt.
Cells numbered(const Dealt& at) {
  Cells cells(at.size(), 0.0f);
  for (int row = 0; row < at.rows; ++row) {
    for (int col = 0; col < at.cols; ++col) {
      cells[std::size_t(at.cell(row, col))] = float(10 * row + col);
    }
  }
  return cells;
}

TEST(DealtArithmetic, UndealsInPlace) {
  for (const int cols : {1, 6, 7}) {
    const Dealt at(5, cols);
    const Cells cells = numbered(at);
    Grid<float> map(at.rows + 2, int(at.stride()));
    std::copy(cells.begin(), cells.end(), map.begin());
    undeal(at, map);
    ASSERT_EQ(map.rows(), 5);
    ASSERT_EQ(map.cols(), cols);
    for (int row = 0; row < 5; ++row) {
      for (int col = 0; col < cols; ++col) EXPECT_EQ(map(row, col), float(10 * row + col));
    }
  }
}

TEST(DealtArithmetic, AddsUpCells) {
  const Dealt at(2, 3);
  const Cells cells = numbered(at);
  EXPECT_EQ(dot(at, cells, cells), 1.0 + 4.0 + 100.0 + 121.0 + 144.0);
  Cells total = cells;
  add_times(at, 2.0, cells, total);
  EXPECT_EQ(total[std::size_t(at.cell(1, 2))], 36.0f);
  Grid<float> map(2, 3, 1.0f);
  add_times(at, -1.0, cells, map);
  EXPECT_EQ(map(1, 1), -10.0f);
  EXPECT_EQ(map(0, 0), 1.0f);
}

}  // namespace
}  // namespace hada
