#include "measure/ring_profile.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

/// Rings of `width` samples that darken towards their end; `dip` of darkness in the middle of the
/// fourth.
std::vector<double> rings(int count, int width, double dip) {
  std::vector<double> brightness;
  for (int ring = 0; ring < count; ++ring) {
    for (int i = 0; i < width; ++i) {
      const double phase = (i + 0.5) / width;
      const double late = std::max(0.0, phase - 0.6) / 0.4;
      const double t = (phase - 0.35) / 0.06;
      brightness.push_back(1.0 - late - (ring == 3 ? dip * std::exp(-0.5 * t * t) : 0.0));
    }
  }
  return brightness;
}

TEST(RingBoundaries, LieWhereLatewoodEnds) {
  const auto found = ring_boundaries(rings(9, 30, 0.0));
  ASSERT_EQ(found.size(), 8u);  // the last ring ends with the profile
  for (std::size_t k = 0; k < found.size(); ++k)
    EXPECT_NEAR(found[k].index, 30.0 * double(k + 1) - 0.5, 0.51);  // the step is between samples
}

TEST(RingBoundaries, AreNotFooledByAFalseRing) {
  EXPECT_EQ(ring_boundaries(rings(9, 30, 0.2)).size(), 8u);
  EXPECT_EQ(ring_boundaries(rings(9, 30, 0.7)).size(), 9u);  // as strong as the others: a ring
}

TEST(RingBoundaries, AreNoneInAPlainProfile) {
  EXPECT_TRUE(ring_boundaries(std::vector<double>(100, 0.5)).empty());
  EXPECT_TRUE(ring_boundaries({}).empty());
}

}  // namespace
}  // namespace hada
