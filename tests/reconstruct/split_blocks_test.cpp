#include "reconstruct/split_blocks.h"

#include <gtest/gtest.h>

#include "reconstruct/coarsen.h"

namespace hada {
namespace {

TEST(SplitBlocks, GiveTheSmallerPartANodeOfItsOwn) {
  // The block in the middle is cut by a wall beside its left column, which hangs on outside.
  Mask mask(6, 6, 1);
  mask(2, 3) = 0;
  mask(3, 2) = 0;
  PixelLevel fine = PixelLevel::of(mask);
  const PixelLevel coarse = coarsened(fine, 0.1f);
  // Cells (2, 2) and (3, 3) touch at a corner only.
  ASSERT_EQ(coarse.extras.size(), 1u);
  EXPECT_EQ(coarse.extras[0].row, 1);
  EXPECT_EQ(coarse.extras[0].col, 1);
  ASSERT_EQ(fine.moved.size(), 1u);
  EXPECT_EQ(std::size_t(fine.moved[0].parent), coarse.at.size());
  // It is joined to the blocks above and on the left, or below and on the right.
  EXPECT_EQ(coarse.edges.size(), 2u);
}

TEST(SplitBlocks, LeaveWholeBlocksAlone) {
  PixelLevel fine = PixelLevel::of(Mask(6, 6, 1));
  EXPECT_TRUE(coarsened(fine, 0.1f).extras.empty());
  EXPECT_TRUE(fine.moved.empty());
}

}  // namespace
}  // namespace hada
