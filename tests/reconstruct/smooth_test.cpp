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
  EXPECT_EQ(fresh, x);
}

TEST(Smooth, SettlesAllCellsAndAddsThemUp) {
  PixelLevel level = some_level();
  Cells x = level.right, total = level.right;
  std::vector<Stage> stages;
  add_settling({level, x.data(), nullptr}, 1.5f, 3.0f * 0x1p22f, total.data(), stages);
  run(level, stages);
  for (int row = 0; row < 6; ++row) {
    for (int col = 0; col < 7; ++col) {
      const auto cell = std::size_t(level.at.cell(row, col));
      EXPECT_EQ(x[cell], std::nearbyint(1.5f * level.right[cell]));
      EXPECT_EQ(total[cell], level.right[cell] + x[cell]);
    }
  }
}

}  // namespace
}  // namespace hada
