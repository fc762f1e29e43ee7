#include "synth/white_noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace hada {
namespace {

std::vector<float> numbers(int rows, int cols, Seed seed) {
  std::vector<float> all(std::size_t(rows) * std::size_t(cols));
  for (int row = 0; row < rows; ++row)
    fill_white_noise(std::span(all).subspan(std::size_t(row * cols), std::size_t(cols)), seed, row);
  return all;
}

TEST(WhiteNoise, FollowsTheNormalDistribution) {
  auto all = numbers(1000, 1000, 1);
  std::sort(all.begin(), all.end());
  double distance = 0.0;
  const auto n = double(all.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double below = 0.5 * std::erfc(-double(all[k]) / std::sqrt(2.0));
    distance = std::max(distance, std::abs(below - (double(k) + 0.5) / n));
  }
  // Kolmogorov and Smirnov: beyond 1.95 / sqrt(n) by chance once in a thousand.
  EXPECT_LT(distance, 1.95e-3);
}

TEST(WhiteNoise, HasTheTailOfTheNormalDistribution) {
  const auto all = numbers(1000, 1000, 2);
  for (const double limit : {3.0, 3.6541528853610088, 4.2}) {
    const double expected = 1e6 * std::erfc(limit / std::sqrt(2.0));
    const auto count =
        std::count_if(all.begin(), all.end(), [&](float v) { return std::abs(double(v)) > limit; });
    // A count scatters by its square root: four of them.
    EXPECT_NEAR(double(count), expected, 4.0 * std::sqrt(expected)) << limit;
  }
}

TEST(WhiteNoise, DoesNotHangTogether) {
  const int n = 1000;
  const auto all = numbers(n, n, 3);
  for (const int apart : {1, 2, n, n + 1}) {
    double sum = 0.0;
    for (std::size_t k = 0; k + std::size_t(apart) < all.size(); ++k)
      sum += double(all[k]) * all[k + std::size_t(apart)];
    // A mean of a million products of variance 1: four deviations of 1e-3.
    EXPECT_NEAR(sum / double(all.size()), 0.0, 4e-3) << apart;
  }
}

TEST(WhiteNoise, BelongsToItsPlace) {
  std::vector<float> longer(50), shorter(20);
  fill_white_noise(longer, 4, 7);
  fill_white_noise(shorter, 4, 7);
  EXPECT_TRUE(std::equal(shorter.begin(), shorter.end(), longer.begin()));
  fill_white_noise(shorter, 5, 7);
  EXPECT_FALSE(std::equal(shorter.begin(), shorter.end(), longer.begin()));
}

}  // namespace
}  // namespace hada
