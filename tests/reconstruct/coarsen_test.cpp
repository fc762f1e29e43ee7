#include "reconstruct/coarsen.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

float east(const PixelLevel& level, int row, int col) {
  return level.east[std::size_t(level.at.cell(row, col))];
}

TEST(Coarsened, KeepsAnEvenLatticeAsItIs) {
  PixelLevel fine = PixelLevel::of(Mask(16, 16, 1));
  PixelLevel coarse = coarsened(fine, 0.1f);
  EXPECT_EQ(coarse.at.rows, 8);
  EXPECT_EQ(east(coarse, 3, 3), 1.0f);
  const PixelLevel next = coarsened(coarse, 0.1f);
  EXPECT_EQ(east(next, 1, 1), 1.0f);
  EXPECT_TRUE(next.extras.empty());
}

TEST(Coarsened, HalvesTheConductanceOfAPath) {
  PixelLevel fine = PixelLevel::of(Mask(1, 16, 1));
  EXPECT_EQ(east(coarsened(fine, 0.1f), 0, 2), 0.5f);  // twice as long
}

TEST(Coarsened, HardlyWeakensABridge) {
  Mask mask(8, 8, 1);
  for (int row = 0; row < 8; ++row) {
    if (row != 3) mask(row, 3) = 0;
  }
  PixelLevel fine = PixelLevel::of(mask);
  // 1 crosses; half of the left block has 1, and half of the right one 2 edges: 1 / (1 + 1/2 +
  // 1/4).
  EXPECT_FLOAT_EQ(east(coarsened(fine, 0.1f), 1, 1), 1.0f / 1.75f);
}

TEST(Coarsened, WorksWhereEitherOfTwoRowsDoes) {
  Mask mask(4, 400, 0);
  for (int col = 150; col < 200; ++col) mask(0, col) = 1;
  for (int col = 190; col < 330; ++col) mask(1, col) = 1;
  PixelLevel fine = PixelLevel::of(mask);
  const PixelLevel coarse = coarsened(fine, 0.1f);
  // Blocks 75 to 164 are the cells 37 to 82 of either half of a coarse row.
  EXPECT_EQ(coarse.stretch(0).first, 32);
  EXPECT_EQ(coarse.stretch(0).last, 96);
  EXPECT_EQ(coarse.stretch(1).last, 0);
  EXPECT_EQ(east(coarse, 0, 120), 0.5f);
}

TEST(Coarsened, GivesBothSidesOfASlitANode) {
  // Levels below: a wall in columns 3 and 4 lies inside a block of 8.
  Mask mask(16, 16, 1);
  for (int row = 0; row < 14; ++row) mask(row, 3) = mask(row, 4) = 0;
  PixelLevel level = PixelLevel::of(mask);
  std::size_t extras = 0;
  while (level.at.rows > 2) {
    PixelLevel next = coarsened(level, 0.1f);
    extras += next.extras.size();
    level = std::move(next);
  }
  EXPECT_GT(extras, 0u);
  for (const auto& extra : level.extras) EXPECT_LT(extra.row, 2);
}

}  // namespace
}  // namespace hada
