#include "synth/forged.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "core/parallel.h"

namespace hada {
namespace {

/// The paper's equations 2 and 4, word for word, over every place of the block.
Grid<double> one_step(const Grid<double>& h, char cut, HammerKernel kernel) {
  const int rows = h.rows(), cols = h.cols();
  Grid<double> cut_and_laid(rows, cols), result(rows, cols);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < cols; ++j) {
      cut_and_laid(i, j) = cut == 'C' ? 0.5 * (h(i, j / 2) + h(i, cols - 1 - j / 2))
                                      : 0.5 * (h(i / 2, j) + h(rows - 1 - i / 2, j));
    }
  }
  const int down = kernel == HammerKernel::both || cut == 'R' ? 1 : 0;
  const int along = kernel == HammerKernel::both || cut == 'C' ? 1 : 0;
  const double weight = 1.0 / ((2 * down + 1) * (2 * along + 1));
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < cols; ++j) {
      for (int u = -down; u <= down; ++u) {
        for (int v = -along; v <= along; ++v) {
          if (h.contains(i + u, j + v)) result(i, j) += weight * cut_and_laid(i + u, j + v);
        }
      }
    }
  }
  return result;
}

class Forging : public ::testing::TestWithParam<std::string> {};

TEST_P(Forging, IsThePapersStepsOneByOne) {
  for (const auto kernel : {HammerKernel::both, HammerKernel::stretched}) {
    Grid<float> block(16, 64);
    Grid<double> slow(16, 64);
    for (int row = 0; row < 16; ++row) {
      for (int col = 0; col < 64; ++col)
        slow(row, col) = block(row, col) = float(gaussian(1, row, col));
    }
    for (const char cut : GetParam()) slow = one_step(slow, cut, kernel);
    const auto fast = hammered(first_cuts(block, GetParam()), GetParam(), kernel);
    ASSERT_TRUE(fast.same_size(block));
    // Every step averages, so that the rounding of floats below 4, 2^-22 at most, adds up at worst
    // over the halvings and means: 3 for each of 7 folds.
    for (std::size_t k = 0; k < slow.size(); ++k) ASSERT_NEAR(fast[k], slow[k], 21 * 0x1p-22);
  }
}

INSTANTIATE_TEST_SUITE_P(Sequences, Forging,
                         ::testing::Values("C", "R", "CR", "RC", "CCC", "RRR", "CRRC", "CRCRCR",
                                           "CCRCCRC", "CCCCCC", "RRRR"));

TEST(Forged, HasTheSameBytesAtAnyThreadCount) {
  const Forged<> forged{.sequence = "CRRCC"};
  set_threads(1);
  auto alone = forged_block(forged, {64, 80}, 3);
  quantise(alone, 70.0, 5.0);
  set_threads(3);
  auto shared = forged_block(forged, {64, 80}, 3);
  quantise(shared, 70.0, 5.0);
  set_threads(0);
  EXPECT_EQ(alone, shared);
}

TEST(Forged, IsAnotherBlockForAnotherSeed) {
  EXPECT_NE(forged_block({.sequence = "CRC"}, {64, 64}, 0),
            forged_block({.sequence = "CRC"}, {64, 64}, 1));
}

TEST(Forged, HasExactlyTheLevelsOfThePaper) {
  auto grain = forged_block({.sequence = "CRCR"}, {256, 256}, 5);
  quantise(grain, 70.0, 5.0);
  std::set<float> levels(grain.begin(), grain.end());
  for (const float level : levels) EXPECT_EQ(level, 5.0f * std::floor(level / 5.0f));
  EXPECT_EQ(*levels.begin(), 0.0f);
  EXPECT_EQ(*levels.rbegin(), 70.0f);
}

TEST(Forged, QuantisesByTheFloorAlsoAtTheEdgesOfLevels) {
  Grid<float> ramp(1, 15);
  for (int k = 0; k < 15; ++k) ramp(0, k) = float(k);
  Grid<float> grey = ramp;
  quantise(grey, 70.0, 5.0);
  for (int k = 0; k < 15; ++k) EXPECT_EQ(grey(0, k), 5.0f * float(k));  // k / 14 * 14 is k
  grey = ramp;
  quantise(grey, 10.0, 4.0);  // 2.5 steps: the highest place is at floor(2.5) = 2
  EXPECT_EQ(grey(0, 14), 8.0f);
  EXPECT_EQ(grey(0, 11), 4.0f);  // 11 / 14 * 2.5 = 1.96
  Grid<float> flat(2, 2, 3.0f);
  quantise(flat, 70.0, 5.0);
  EXPECT_EQ(flat, Grid<float>(2, 2));
}

TEST(Forged, RoundsABlockUpToWhatCanBeHalved) {
  const auto size = divisible({100, 100}, "CRC");
  EXPECT_EQ(size.rows, 100);
  EXPECT_EQ(size.cols, 100);
  EXPECT_EQ(divisible({101, 101}, "CRC").cols, 102);
  EXPECT_EQ(divisible({101, 101}, "CC").rows, 101);
}

TEST(Forged, KnowsWordsThatAreNoFolds) {
  EXPECT_FALSE(is_fold_sequence(""));
  EXPECT_FALSE(is_fold_sequence("CRX"));
  EXPECT_FALSE(is_fold_sequence(std::string(17, 'C')));
  EXPECT_TRUE(is_fold_sequence("CRCRCR"));
  EXPECT_FALSE(is_hammer_kernel("round"));
  EXPECT_EQ(hammer_kernel("stretched"), HammerKernel::stretched);
}

}  // namespace
}  // namespace hada
