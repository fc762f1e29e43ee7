#include "reconstruct/coarsen_kernels.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace hada {
namespace {

/// What `join` says of one block of a mask, a0 b0 over a1 b1, with all in the mask around it.
std::array<float, 5> joined(std::array<std::uint8_t, 4> block) {
  const std::array<std::uint8_t, 2> a0{block[0], 1}, b0{block[1], 1}, a1{block[2], 1},
      b1{block[3], 1}, below{1, 1};
  std::array<float, 5> found{};
  coarsen_kernels::join(1, {a0.data(), b0.data(), a1.data(), b1.data(), below.data(), below.data()},
                        &found[0], &found[1], &found[2], &found[3], &found[4]);
  return found;
}

TEST(CoarsenKernels, CountTheEdgesOfABlockAndSeeWhereItFallsApart) {
  EXPECT_EQ(joined({1, 1, 1, 1}), (std::array<float, 5>{2, 2, 2, 2, 0}));
  EXPECT_EQ(joined({1, 1, 1, 0}), (std::array<float, 5>{1, 1, 1, 1, 0}));
  EXPECT_EQ(joined({1, 0, 0, 1}), (std::array<float, 5>{0, 0, 1, 1, 1}));
  EXPECT_EQ(joined({0, 0, 0, 0}), (std::array<float, 5>{0, 0, 0, 0, 0}));
}

TEST(CoarsenKernels, JoinCellsByWeakEdgesLessThanLeast) {
  const auto split = [](float across, float least) {
    // Two rows of two cells, joined along by edges of 1; across by `across` alone.
    const float one = 1.0f, inverse = 1.0f / (1.0f + across);
    const float* const w = &one;
    const coarsen_kernels::WeightedRows rows{&across, w, &across,  w,        w,        w,
                                             w,       w, &inverse, &inverse, &inverse, &inverse};
    std::array<float, 5> found{};
    coarsen_kernels::join(1, rows, least, &found[0], &found[1], &found[2], &found[3], &found[4]);
    return found[4];
  };
  EXPECT_EQ(split(1.0f, 0.1f), 0.0f);
  EXPECT_EQ(split(0.01f, 0.1f), 1.0f);
}

TEST(CoarsenKernels, PutEdgesInSeries) {
  std::vector<float> cross{2.0f, 0.0f};
  const std::vector<float> reach{0.25f, 0.25f}, beyond{0.5f, 0.5f};
  coarsen_kernels::in_series(2, cross.data(), reach.data(), beyond.data());
  EXPECT_FLOAT_EQ(cross[0], 1.0f / (0.5f + 0.25f + 0.5f));
  EXPECT_EQ(cross[1], 0.0f);
}

TEST(CoarsenKernels, InvertWhatIsNotZero) {
  std::vector<float> reach{2.0f, 0.0f};
  coarsen_kernels::to_reach(2, reach.data());
  EXPECT_EQ(reach, (std::vector<float>{0.25f, 0.0f}));
  const std::vector<float> some{1.0f, 0.0f};
  std::vector<float> inverse(2, 7.0f);
  coarsen_kernels::invert(2, inverse.data(), {some.data(), some.data(), some.data(), some.data()});
  EXPECT_EQ(inverse, (std::vector<float>{0.25f, 0.0f}));
}

TEST(CoarsenKernels, MarkCellsOfAnEvenLatticeAlone) {
  const std::vector<float> one(4, 1.0f), quarter(4, 0.25f);
  auto weak = one, far = quarter;
  weak[1] = 0.5f;
  far[2] = 0.3f;
  std::vector<std::uint8_t> even(4, 9);
  coarsen_kernels::find_even(4, {one.data(), weak.data(), one.data(), one.data()}, quarter.data(),
                             far.data(), quarter.data(), even.data());
  EXPECT_EQ(even, (std::vector<std::uint8_t>{1, 0, 0, 1}));
}

}  // namespace
}  // namespace hada
