#include "reconstruct/rise_kernels.h"

#include <vector>

#include <gtest/gtest.h>

namespace hada {
namespace {

constexpr float magic =
    3.0f * 4194304.0f / 4096.0f;  // rounds to 1 / 4096, which all values here are

TEST(RiseKernels, AreMeanSlopesBetweenPixelsOfTheMask) {
  // Pairs (dz/dx, dz/dy) of three pixels and the three below.
  const std::vector<float> here{0.5f, 1.0f, 0.25f, 2.0f, 1.0f, -1.0f};
  const std::vector<float> below{0.0f, 0.5f, 0.0f, 0.0f, 0.0f, 1.0f};
  const std::vector<std::uint8_t> mask{1, 1, 0}, mask_below{1, 0, 1};
  std::vector<float> rise(2);
  rise_kernels::rise_across(2, here.data(), mask.data(), magic, rise.data());
  EXPECT_EQ(rise, (std::vector<float>{0.375f, 0.0f}));
  // y points up: the rise to the row below is against the slope.
  std::vector<float> down(3);
  rise_kernels::rise_down(3, here.data(), below.data(), mask.data(), mask_below.data(), magic,
                          down.data());
  EXPECT_EQ(down, (std::vector<float>{-0.75f, 0.0f, 0.0f}));
}

TEST(RiseKernels, BalanceWhatRisesAskOfAPixel) {
  const std::vector<float> across{1.0f, 3.0f, 4.0f}, above{0.5f, 0.0f}, below{0.25f, 1.0f};
  std::vector<float> out(2);
  rise_kernels::balance(2, across.data() + 1, above.data(), below.data(), out.data());
  EXPECT_EQ(out, (std::vector<float>{-2.0f + 0.25f, -1.0f - 1.0f}));
}

}  // namespace
}  // namespace hada
