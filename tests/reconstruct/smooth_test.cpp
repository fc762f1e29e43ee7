#include "reconstruct/smooth.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

/// A level of 6 x 7 cells, all joined, whose right-hand side sums to 0.
PixelLevel some_level() {
  PixelLevel level = PixelLevel::of(Mask(6, 7, 1));
  level.right.assign(level.nodes(), 0.0f);
  for (int row = 0; row < 6; ++row) {
    for (int col = 0; col < 7; ++col)
      level.right[std::size_t(level.at.cell(row, col))] = float((3 * row + col) % 7 - 3);
  }
  return level;
}

void run(const PixelLevel& level, const std::vector<Stage>& stages) {
  run_wavefront(level.at.rows, level.at.size(), stages);
}

TEST(Smooth, LeavesNothingAtBlackCellsAfterAPlainSweep) {
  PixelLevel level = some_level();
  Cells x(level.nodes(), 0.0f), right = level.right;
  std::vector<Stage> stages;
  add_sweep({level, x.data(), right.data()}, {1.2f, 1.0f}, stages);
  add_subtraction({level, x.data(), right.data()}, stages);
  run(level, stages);
  double red = 0.0;
  for (int row = 0; row < 6; ++row) {
    for (int col = 0; col < 7; ++col) {
      const float rest = right[std::size_t(level.at.cell(row, col))];
      // Five sums of numbers below 16, each rounded to 2^-24 of it.
      if ((row + col) % 2 == 0) {
        red += std::abs(rest);
      } else {
        EXPECT_NEAR(rest, 0.0f, 5 * 16 * std::ldexp(1.0f, -24));
      }
    }
  }
  EXPECT_GT(red, 1.0);
}

TEST(Smooth, FromZeroIsASweepOfZeros) {
  PixelLevel level = some_level();
  Cells x(level.nodes(), 0.0f), fresh(level.nodes(), 0.0f), right = level.right;
  std::vector<Stage> stages;
  add_sweep({level, x.data(), right.data()}, {1.2f, 1.0f}, stages);
  run(level, stages);
  stages.clear();
  for (int row = 0; row < 6; ++row) {
    for (int col = 0; col < 7; ++col) fresh[std::size_t(level.at.cell(row, col))] = 9.0f;
  }
  add_sweep_from_zero({level, fresh.data(), right.data()}, 1.2f, stages);
  run(level, stages);
  // A step of about 1 from a value below 3, and one from nothing: each rounds to 2^-24 of 4 twice.
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(fresh[i], x[i], std::ldexp(16.0f, -24));
}

TEST(Smooth, RestrictsTheExactResidualOfALargeHeight) {
  // 1/8 of whole numbers on a height of 4096: nothing is rounded.
  PixelLevel level = some_level();
  Cells x(level.nodes(), 0.0f), rest = level.right;
  for (int row = 0; row < 6; ++row) {
    for (int col = 0; col < 7; ++col) {
      x[std::size_t(level.at.cell(row, col))] = 4096.0f + 0.125f * float(row * row - 2 * col);
    }
  }
  PixelLevel coarse;
  coarse.at = Dealt(3, 4);
  coarse.right.assign(coarse.at.size(), 0.0f);
  std::vector<Stage> stages;
  add_exact_restriction({level, x.data(), level.right.data()}, coarse, stages);
  run(level, stages);
  stages.clear();
  add_subtraction({level, x.data(), rest.data()}, stages);
  run(level, stages);
  const auto at = [&](int row, int col) { return std::size_t(level.at.cell(row, col)); };
  // Inside: 1/8 of the second difference, 2, along the columns.
  EXPECT_EQ(rest[at(2, 3)], level.right[at(2, 3)] + 0.25f);
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 4; ++col) {
      const auto in_row = [&](int r) {  // the last block has one column
        return rest[at(r, 2 * col)] + (col < 3 ? rest[at(r, 2 * col + 1)] : 0.0f);
      };
      EXPECT_EQ(coarse.right[std::size_t(coarse.at.cell(row, col))],
                in_row(2 * row) + in_row(2 * row + 1));
    }
  }
}

TEST(Smooth, GathersTheRightHandSideOfBlocks) {
  PixelLevel level = some_level();
  // One cell belongs to an extra node, its block keeps the rest.
  const auto cell = PixelLevel::Node(level.at.cell(2, 3));
  PixelLevel coarse;
  coarse.at = Dealt(3, 4);
  const auto extra = PixelLevel::Node(coarse.at.size());
  coarse.right.assign(coarse.at.size() + 1, 0.0f);
  level.moved.push_back({2, cell, extra});
  std::vector<Stage> stages;
  add_gathering(level, coarse, stages);
  run(level, stages);
  Grid<float> expected(3, 4);
  for (int row = 0; row < 6; ++row) {
    for (int col = 0; col < 7; ++col) {
      expected(row / 2, col / 2) += level.right[std::size_t(level.at.cell(row, col))];
    }
  }
  EXPECT_EQ(coarse.right[std::size_t(extra)], level.right[std::size_t(cell)]);
  expected(1, 1) -= level.right[std::size_t(cell)];
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 4; ++col) {
      EXPECT_EQ(coarse.right[std::size_t(coarse.at.cell(row, col))], expected(row, col));
    }
  }
}

}  // namespace
}  // namespace hada
