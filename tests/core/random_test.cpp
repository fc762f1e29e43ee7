#include "core/random.h"

#include <bit>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace hada {
namespace {

constexpr int draws = 100000;

TEST(Random, DependsOnTheKeyAlone) {
  EXPECT_EQ(hash(1, 2, 3, 4), hash(1, 2, 3, 4));
  std::set<std::uint64_t> seen;
  for (int i = -5; i < 5; ++i) {
    for (int j = -5; j < 5; ++j) {
      for (int k = -5; k < 5; ++k) seen.insert(hash(9, i, j, k));
    }
  }
  EXPECT_EQ(seen.size(), 1000u);  // a collision of 1000 in 2^64 has a chance of 3e-14
}

TEST(Random, ChangesHalfOfTheBitsWithTheNextKey) {
  double bits = 0.0;
  for (int i = 0; i < draws; ++i) bits += std::popcount(hash(3, i) ^ hash(3, i + 1));
  // 64 fair coins: standard deviation 4, of the mean 4 / sqrt(draws) = 0.013; five of them.
  EXPECT_NEAR(bits / draws, 32.0, 0.063);
}

TEST(Random, IsUniformBetweenZeroAndOne) {
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < draws; ++i) {
    const double x = uniform(11, i, 7);
    ASSERT_GT(x, 0.0);
    ASSERT_LT(x, 1.0);
    sum += x;
    squares += x * x;
  }
  // Standard deviations 0.289 and 0.298 over sqrt(draws); five of them.
  EXPECT_NEAR(sum / draws, 1.0 / 2.0, 0.0046);
  EXPECT_NEAR(squares / draws, 1.0 / 3.0, 0.0047);
}

TEST(Random, IsGaussianToTheFourthMoment) {
  double sum = 0.0;
  double squares = 0.0;
  double fourths = 0.0;
  double product = 0.0;
  for (int i = 0; i < draws; ++i) {
    const double x = gaussian(11, i);
    sum += x;
    squares += x * x;
    fourths += x * x * x * x;
    product += x * gaussian(11, i + 1);
  }
  // Standard deviations 1, sqrt(2), sqrt(96) and 1 over sqrt(draws); five of them.
  EXPECT_NEAR(sum / draws, 0.0, 0.016);
  EXPECT_NEAR(squares / draws, 1.0, 0.023);
  EXPECT_NEAR(fourths / draws, 3.0, 0.155);
  EXPECT_NEAR(product / draws, 0.0, 0.016);
}

}  // namespace
}  // namespace hada
