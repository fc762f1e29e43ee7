#include "core/bounding_box.h"

#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(BoundingBox, HoldsExactlyThePixelsThatCount) {
  Mask mask(8, 10, 0);
  mask(2, 7) = 1;
  mask(5, 3) = 1;
  const PixelBox box = bounding_box(mask);
  EXPECT_EQ(box.row, 2);
  EXPECT_EQ(box.col, 3);
  EXPECT_EQ(box.rows, 4);
  EXPECT_EQ(box.cols, 5);
}

TEST(LargestBoxInside, IsAsLargeAsAnyThatOneCanTry) {
  Mask mask(7, 9, 1);
  for (const auto& [row, col] : {std::pair{1, 2}, {1, 6}, {4, 4}, {5, 0}, {6, 7}})
    mask(row, col) = 0;
  int most = 0;
  for (int row = 0; row < 7; ++row) {
    for (int col = 0; col < 9; ++col) {
      for (int rows = 1; row + rows <= 7; ++rows) {
        for (int cols = 1; col + cols <= 9; ++cols) {
          const Mask part = crop(mask, row, col, rows, cols);
          if (std::count(part.begin(), part.end(), 0) == 0) most = std::max(most, rows * cols);
        }
      }
    }
  }
  const PixelBox box = largest_box_inside(mask);
  EXPECT_EQ(box.rows * box.cols, most);
  const Mask part = crop(mask, box.row, box.col, box.rows, box.cols);
  EXPECT_EQ(std::count(part.begin(), part.end(), 0), 0);
}

TEST(LargestBoxInside, IsEmptyOrTheWholeOfSuchMasks) {
  EXPECT_EQ(largest_box_inside(Mask(3, 4, 0)).rows, 0);
  const PixelBox whole = largest_box_inside(Mask(3, 4, 1));
  EXPECT_EQ(whole.rows, 3);
  EXPECT_EQ(whole.cols, 4);
}

}  // namespace
}  // namespace hada
