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

TEST(PixelLevel, TakesWeightsInsideTheMaskOnly) {
  Mask mask(1, 3, 1);
  mask(0, 2) = 0;
  const PixelLevel level = PixelLevel::of(mask, {Grid<float>(1, 3, 4.0f), Grid<float>(1, 3, 4.0f)});
  EXPECT_EQ(level.east[std::size_t(level.at.cell(0, 0))], 4.0f);
  EXPECT_EQ(level.east[std::size_t(level.at.cell(0, 1))], 0.0f);
  EXPECT_EQ(level.inverse[std::size_t(level.at.cell(0, 1))], 0.25f);
}

TEST(EdgeWeights, AreOneOverTheMeanVarianceOfBothPixels) {
  Grid<float> weight(1, 2);
  weight(0, 0) = 1.0f;
  weight(0, 1) = 0.25f;
  EXPECT_EQ(edge_weights(weight).east(0, 0), 0.4f);  // 1 / mean(1, 4)
}

}  // namespace
}  // namespace hada
