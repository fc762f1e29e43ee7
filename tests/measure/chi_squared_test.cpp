#include "measure/chi_squared.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

TEST(ChiSquaredQuantile, AgreesWithClosedForms) {
  // Two degrees of freedom are an exponential of mean 2, one is a squared normal number.
  for (const double p : {0.025, 0.5, 0.975}) {
    EXPECT_NEAR(chi_squared_quantile(2.0, p), -2.0 * std::log(1.0 - p), 1e-9);
  }
  EXPECT_NEAR(chi_squared_quantile(1.0, 0.95), 1.959963985 * 1.959963985, 1e-7);
}

TEST(PowerInterval, HoldsTheExpectationAsOftenAsItSays) {
  // Means of five exponential ordinates of expectation 3.
  constexpr int many = 4000, ordinates = 5;
  int held = 0;
  for (int i = 0; i < many; ++i) {
    double sum = 0.0;
    for (int j = 0; j < ordinates; ++j) sum -= 3.0 * std::log(uniform(5, i, j));
    const double mean = sum / ordinates;
    const Interval interval = power_interval(mean, mean / std::sqrt(double(ordinates)));
    held += interval.low < 3.0 && 3.0 < interval.high;
  }
  // A share of 0.95 of 4000 has a standard deviation of 0.0034; three of them.
  EXPECT_NEAR(double(held) / many, 0.95, 0.011);
}

TEST(PowerInterval, GoesOverIntoANormalOne) {
  const Interval below = power_interval(1.0, 0.01001), above = power_interval(1.0, 0.00999);
  // What is left of the skewness, 2 sigma = 0.02 of one, moves the ends by less than 0.04 sigma.
  EXPECT_NEAR(below.low, above.low, 4e-4);
  EXPECT_NEAR(below.high, above.high, 4e-4);
}

TEST(PowerInterval, IsUnknownWhereNothingWasAveraged) {
  EXPECT_TRUE(std::isnan(power_interval(0.0, 0.0).low));
}

}  // namespace
}  // namespace hada
