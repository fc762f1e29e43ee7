#include "measure/chi_squared.h"

#include <cmath>
#include <limits>

#include <Eigen/Core>
#include <unsupported/Eigen/SpecialFunctions>

namespace hada {

double chi_squared_quantile(double freedom, double probability) {
  const auto below = [&](double x) { return Eigen::numext::igamma(0.5 * freedom, 0.5 * x); };
  // Thirty standard deviations above the mean lies everything that a double can tell from 1.
  double low = 0.0, high = freedom + 30.0 * std::sqrt(2.0 * freedom) + 60.0;
  while (true) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return middle;
    (below(middle) < probability ? low : high) = middle;
  }
}

Interval power_interval(double mean, double sigma, double share) {
  const double freedom = 2.0 * (mean / sigma) * (mean / sigma);
  if (!std::isfinite(freedom) || freedom <= 0.0) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return {unknown, unknown};
  }
  // Beyond this the distribution is normal to a part in a thousand of its width.
  constexpr double many = 2e4;
  if (freedom > many) {
    const double reach = sigma * std::sqrt(chi_squared_quantile(1.0, share));
    return {mean - reach, mean + reach};
  }
  return {mean * freedom / chi_squared_quantile(freedom, 0.5 * (1.0 + share)),
          mean * freedom / chi_squared_quantile(freedom, 0.5 * (1.0 - share))};
}

}  // namespace hada
