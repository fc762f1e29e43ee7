#pragma once

namespace hada {

/// Where the expectation of a power lies.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// The value that a chi-squared variable stays below with the given probability.
///
/// freedom      > 0, need not be whole
/// probability  above 0 and below 1
double chi_squared_quantile(double freedom, double probability);

/// The interval that holds the expectation of a mean power with the probability `share`: a mean of
/// ordinates, each exponentially distributed, is chi-squared over its 2 (mean / sigma)^2 degrees of
/// freedom times its expectation. Not symmetric, and never below 0. NaN where nothing was averaged.
Interval power_interval(double mean, double sigma, double share = 0.95);

}  // namespace hada
