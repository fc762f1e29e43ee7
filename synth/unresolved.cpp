#include "synth/unresolved.h"

#include <algorithm>
#include <cmath>

namespace hada {
namespace {

/// Of all slopes: the second derivatives of the autocovariance at 0, with the other sign.
SlopeCovariance all_slopes(const GaussianCovariance<>& covariance) {
  const auto& [variance, xx, xy, yy] = covariance;
  return {2.0 * variance * xx, 2.0 * variance * xy, 2.0 * variance * yy};
}

SlopeCovariance all_slopes(const RepeatedCovariance<>& covariance) {
  const auto& [kernel, x, y, fall] = covariance;
  // Of the kernel n periods away, whose slope at 0 is 2 M n p times its value.
  const double across = kernel.xx * x + kernel.xy * y, up = kernel.xy * x + kernel.yy * y;
  const double a = fall + kernel.exponent(x, y);
  SlopeCovariance sum;
  for (double n = -std::floor(std::sqrt(no_likeness / a)); a * n * n <= no_likeness; ++n) {
    const double value = kernel.variance * std::exp(-a * n * n);
    sum.xx += value * (2.0 * kernel.xx - 4.0 * n * n * across * across);
    sum.xy += value * (2.0 * kernel.xy - 4.0 * n * n * across * up);
    sum.yy += value * (2.0 * kernel.yy - 4.0 * n * n * up * up);
  }
  return sum;
}

SlopeCovariance all_slopes(const WovenCovariance<>& covariance) {
  const GaussianCovariance<>& kernel = covariance.kernel;
  const auto& p = covariance.p;
  const auto& q = covariance.q;
  SlopeCovariance sum;
  for_each_crossing(covariance.nn + inner(kernel, p, p), covariance.nm + inner(kernel, p, q),
                    covariance.mm + inner(kernel, q, q), 0.0, 0.0, 0.0,
                    [&](double n, double m, double weight) {
                      const double x = n * p.x + m * q.x, y = n * p.y + m * q.y;
                      const double across = kernel.xx * x + kernel.xy * y;
                      const double up = kernel.xy * x + kernel.yy * y;
                      const double value = kernel.variance * weight;
                      sum.xx += value * (2.0 * kernel.xx - 4.0 * across * across);
                      sum.xy += value * (2.0 * kernel.xy - 4.0 * across * up);
                      sum.yy += value * (2.0 * kernel.yy - 4.0 * up * up);
                    });
  return sum;
}

template <class Covariance>
void add_unresolved(const Covariance& covariance, double pitch, SlopeCovariance& left) {
  const auto at = [&](int cols, int rows) {
    return value_at(covariance, cols * pitch, rows * pitch);
  };
  const double area = 2.0 * pitch * pitch;
  const SlopeCovariance all = all_slopes(covariance);
  left.xx += all.xx - (at(0, 0) - at(2, 0)) / area;
  left.yy += all.yy - (at(0, 0) - at(0, 2)) / area;
  left.xy += all.xy - (at(1, -1) - at(1, 1)) / area;
}

}  // namespace

SlopeCovariance unresolved_slopes(const Wrinkle<>& wrinkle, double pitch) {
  SlopeCovariance left;
  for_each_noise(wrinkle,
                 [&](const auto& noise) { add_unresolved(autocovariance(noise), pitch, left); });
  return left;
}

double roughness_of(const SlopeCovariance& slopes) {
  const double alpha = std::sqrt(std::max(slopes.xx + slopes.yy, 0.0));
  return std::min(std::sqrt(alpha), 1.0);
}

}  // namespace hada
