#include "reconstruct/noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/quantile.h"
#include "reconstruct/box_sum.h"

namespace hada {
namespace {

constexpr double rounding = 1.0 / 65535.0;  // samples are never known better than 16 bits
constexpr double least_variance = rounding * rounding / 12.0;
constexpr double prior_freedom = 20.0;  // how many residuals the typical noise is worth

}  // namespace

double median_of_chi_squared(double freedom) {
  return std::pow(1.0 - 2.0 / (9.0 * freedom), 3.0);
}

double typical_noise(const Residuals& residuals) {
  std::vector<double> variances;
  variances.reserve(residuals.squares.size());
  for (std::size_t i = 0; i < residuals.squares.size(); ++i) {
    const double freedom = residuals.freedom[i];
    if (freedom <= 0.0) continue;
    variances.push_back(residuals.squares[i] / (freedom * median_of_chi_squared(freedom)));
  }
  if (variances.empty()) return prior_noise;
  return std::sqrt(std::max(median(std::move(variances)), least_variance));
}

Grid<float> local_variance(const Residuals& residuals, double noise) {
  const Grid<float> freedom = box_sum(residuals.freedom, pool_radius_px);
  Grid<float> variance = box_sum(residuals.squares, pool_radius_px);
  for (std::size_t i = 0; i < variance.size(); ++i) {
    const double pooled =
        (variance[i] + prior_freedom * noise * noise) / (freedom[i] + prior_freedom);
    variance[i] = float(std::max(pooled, least_variance));
  }
  return variance;
}

}  // namespace hada
