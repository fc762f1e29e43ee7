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

}  // namespace
}  // namespace hada
