#include "reconstruct/coarsest.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(CoarsestSolver, SolvesEveryRegionUpToItsMean) {
  Mask mask(3, 4, 1);  // a path of four, and one of four below an empty row
  for (int col = 0; col < 4; ++col) mask(1, col) = 0;
  PixelLevel level = PixelLevel::of(mask);
  level.value.assign(level.nodes(), 0.0f);
  level.right.assign(level.nodes(), 0.0f);
  const auto cell = [&](int row, int col) { return std::size_t(level.at.cell(row, col)); };
  level.right[cell(0, 0)] = -1.0f;  // a force of 1 along the first path: a rise of 1 at each step
  level.right[cell(0, 3)] = 1.0f;
  EXPECT_EQ(CoarsestSolver::size_of(level), 8u);
  CoarsestSolver solver(level);
  solver.solve(level);
  for (int col = 0; col < 4; ++col) {
    EXPECT_FLOAT_EQ(level.value[cell(0, col)], float(col) - 1.5f);
    EXPECT_FLOAT_EQ(level.value[cell(2, col)], 0.0f);
    EXPECT_EQ(level.value[cell(1, col)], 0.0f);
  }
}

}  // namespace
}  // namespace hada
