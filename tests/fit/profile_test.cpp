#include "fit/profile.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

constexpr double inf = HUGE_VAL;
const double root = std::sqrt(rise_of_one);

/// Two numbers, each measured, and their sum: the profile of a Gaussian is its marginal.
ResidualFunction correlated() {
  return [](const double* at, double* r, double* jacobian) {
    r[0] = (at[0] - 3.0) / 0.5;
    r[1] = (at[1] - 1.0) / 2.0;
    r[2] = (at[0] + at[1] - 4.0) / 0.1;
    if (jacobian) std::copy_n(std::array{2.0, 0.0, 0.0, 0.5, 10.0, 10.0}.begin(), 6, jacobian);
  };
}

std::array<double, 2> interval_of_first(const std::vector<SolverBounds>& bounds,
                                        const WhileHeld& while_held = {}) {
  return profile_interval(
      {3.0, 1.0}, 0, 0.2, rise_of_one, bounds, 3, [](double) { return correlated(); }, while_held);
}

TEST(Profile, IsTheMarginalOfAGaussian) {
  const auto [low, high] = interval_of_first({{-inf, inf}, {-inf, inf}});
  // 1 / (4 + 100 - 100^2 / 100.25) by the Schur complement; the ends are met to 0.02 of root 3.84.
  const double sigma = 1.0 / std::sqrt(104.0 - 1e4 / 100.25);
  EXPECT_NEAR(low, 3.0 - root * sigma, 0.02 * sigma);
  EXPECT_NEAR(high, 3.0 + root * sigma, 0.02 * sigma);
}

TEST(Profile, EndsAtABoundThatTheDataDoNotTell) {
  const auto [low, high] = interval_of_first({{2.9, inf}, {-inf, inf}});
  EXPECT_EQ(low, 2.9);
  EXPECT_GT(high, 3.5);
}

TEST(Profile, KeepsTheOthersWhereTheyBelong) {
  // The second may not pass the first less two: what it would give way by, it cannot.
  const auto [low, high] = interval_of_first(
      {{-inf, inf}, {-inf, inf}},
      [](double value, std::vector<SolverBounds>& bounds) { bounds[1].low = value - 2.0; });
  const double free = 1.0 / std::sqrt(104.0 - 1e4 / 100.25), held = 1.0 / std::sqrt(4.25 + 400.0);
  EXPECT_NEAR(high, 3.0 + root * held, 0.02 * held);
  EXPECT_NEAR(low, 3.0 - root * free, 0.02 * free);
}

TEST(Profile, NeedsNoSpreadAndStopsWhereNothingIsFinite) {
  // A number measured as 0, with deviation 1, that must lie below 1.5 for anything to be known.
  const auto residuals = [](const double* at, double* r, double* jacobian) {
    r[0] = at[0] < 1.5 ? at[0] : std::nan("");
    if (jacobian) jacobian[0] = 1.0;
  };
  const auto [low, high] = profile_interval({0.0}, 0, 0.0, rise_of_one, {{-9.0, 9.0}}, 1,
                                            [&](double) { return residuals; });
  EXPECT_NEAR(low, -root, 0.02);
  EXPECT_NEAR(high, 1.5, 0.01);  // 16 steps, half way again and again
}

TEST(Profile, IsAsLopsidedAsTheLikelihood) {
  // Ten exponential numbers of mean 1: the logarithm s of their expectation costs 10 (s + e^-s).
  const auto residuals = [](const double* at, double* r, double* jacobian) {
    const double s = at[0], cost = 10.0 * (s + std::exp(-s) - 1.0);
    r[0] = std::copysign(std::sqrt(2.0 * cost), s);
    if (jacobian) jacobian[0] = s == 0.0 ? std::sqrt(10.0) : 10.0 * (1.0 - std::exp(-s)) / r[0];
  };
  const auto [low, high] = profile_interval({0.0}, 0, 0.3, rise_of_one, {{-9.0, 9.0}}, 1,
                                            [&](double) { return residuals; });
  const auto rise = [](double s) { return std::sqrt(20.0 * (s + std::exp(-s) - 1.0)); };
  EXPECT_NEAR(rise(low), root, 0.02);
  EXPECT_NEAR(rise(high), root, 0.02);
  EXPECT_GT(high, -1.15 * low);
}

}  // namespace
}  // namespace hada
