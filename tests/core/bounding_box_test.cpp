#include "core/bounding_box.h"

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

}  // namespace
}  // namespace hada
