#include "reconstruct/pixel_level.h"

#include <gtest/gtest.h>

#include "reconstruct/row_kernels.h"

namespace hada {
namespace {

TEST(PixelLevel, CountsTheEdgesOfEveryPixel) {
  Mask mask(3, 3, 1);
  mask(0, 1) = 0;
  mask(0, 2) = 0;
  const PixelLevel level = PixelLevel::of(mask);
  const auto code = [&](int row, int col) {
    return level.code[std::size_t(level.at.cell(row, col))];
  };
  EXPECT_EQ(code(0, 0), row_kernels::edge_code(1));
  EXPECT_EQ(code(0, 1), 0);
  EXPECT_EQ(code(1, 0), row_kernels::edge_code(3));
  EXPECT_EQ(code(1, 1), row_kernels::edge_code(3));
  EXPECT_EQ(code(2, 2), row_kernels::edge_code(2));
}

TEST(PixelLevel, WorksWhereThereArePixels) {
  Mask mask(3, 200, 0);
  for (int col = 70; col < 150; ++col) mask(1, col) = 1;
  mask(2, 180) = 1;  // without an edge
  const PixelLevel level = PixelLevel::of(mask);
  EXPECT_EQ(level.half_row(0, 0).count, 0);
  // Pixels 70 to 149 are the cells 35 to 74 of either block.
  EXPECT_EQ(level.stretch(1).first, 32);
  EXPECT_EQ(level.stretch(1).last, 80);
  EXPECT_EQ(level.half_row(2, 1).count, 0);
}

}  // namespace
}  // namespace hada
