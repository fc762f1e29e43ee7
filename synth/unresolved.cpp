#include "synth/unresolved.h"

#include <algorithm>
#include <cmath>

namespace hada {

SlopeCovariance unresolved_slopes(const Wrinkle<>& wrinkle, double pitch) {
  SlopeCovariance left;
  const double area = pitch * pitch;
  // (1 - exp(-4 q p^2)) / (2 p^2): what differences over two pixels keep of 2 q.
  const auto kept = [&](double q) { return -std::expm1(-4.0 * q * area) / (2.0 * area); };
  for (const auto& component : wrinkle.components) {
    const auto [variance, xx, xy, yy] = autocovariance(component);
    left.xx += variance * (2.0 * xx - kept(xx));
    left.yy += variance * (2.0 * yy - kept(yy));
    const double kept_xy =
        0.5 / area *
        (std::exp(-(xx + yy - 2.0 * xy) * area) - std::exp(-(xx + yy + 2.0 * xy) * area));
    left.xy += variance * (2.0 * xy - kept_xy);
  }
  return left;
}

double roughness_of(const SlopeCovariance& slopes) {
  const double alpha = std::sqrt(std::max(slopes.xx + slopes.yy, 0.0));
  return std::min(std::sqrt(alpha), 1.0);
}

}  // namespace hada
