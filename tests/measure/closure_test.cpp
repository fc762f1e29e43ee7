#include "measure/closure.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hada {
namespace {

using Eigen::Vector2d;

// A pyramid of four planes of steepness t, creases along the diagonals: each face has an angle of
// acos(t^2 / (2 + t^2)) at its top, since its edges (1, 1, -t) and (1, -1, -t) rise alike.
std::vector<ClosureWay> pyramid(double t, double slope_sigma, double way_sigma) {
  const Vector2d slopes[4] = {{-t, 0}, {0, -t}, {t, 0}, {0, t}};
  const Vector2d ways[4] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  std::vector<ClosureWay> all;
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    all.push_back({ways[k], way_sigma, slopes[k], slopes[next], slope_sigma, slope_sigma, k, next});
  }
  return all;
}

TEST(Closure, OfAPyramidLacksWhatItMust) {
  for (const double t : {0.0, 0.1, 0.5}) {
    const double lack = 2.0 * std::numbers::pi - 4.0 * std::acos(t * t / (2.0 + t * t));
    EXPECT_NEAR(closure_of(pyramid(t, 0.0, 0.0)).lack, lack, 1e-12);
    EXPECT_EQ(closure_of(pyramid(t, 0.0, 0.0)).sigma, 0.0);
  }
}

TEST(Closure, IsAsUncertainAsItsPlanes) {
  // d lack / d slope by hand: each of the eight slopes moves the lack by a share of its own; a
  // common steepness t moves it by 4 d acos(t^2 / (2 + t^2)) / dt. Only the four slopes along their
  // own axis contribute by symmetry, a quarter each; they err independently.
  const double t = 0.3, sigma = 1e-4;
  const auto angle = [](double s) { return 4.0 * std::acos(s * s / (2.0 + s * s)); };
  const double whole = (angle(t + 1e-5) - angle(t - 1e-5)) / 2e-5;
  const double expected = sigma * std::abs(whole) / 4.0 * 2.0;
  EXPECT_NEAR(closure_of(pyramid(t, sigma, 0.0)).sigma, expected, 1e-3 * expected);
  // Twice as uncertain planes, twice as uncertain a closure.
  EXPECT_NEAR(closure_of(pyramid(t, 2.0 * sigma, 0.0)).sigma, 2.0 * expected, 2e-3 * expected);
}

}  // namespace
}  // namespace hada
