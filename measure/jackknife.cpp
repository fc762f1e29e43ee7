#include "measure/jackknife.h"

#include <cmath>
#include <limits>

namespace hada {

double jackknife_sigma(double whole, const std::vector<LeftOut>& left_out) {
  const double groups = double(left_out.size());
  if (groups < 2.0) return std::numeric_limits<double>::quiet_NaN();
  double estimate = groups * whole;
  for (const auto& [value, ratio] : left_out) estimate -= value * (1.0 - 1.0 / ratio);
  double sum = 0.0;
  for (const auto& [value, ratio] : left_out) {
    const double pseudo = ratio * whole - (ratio - 1.0) * value;
    sum += (pseudo - estimate) * (pseudo - estimate) / (ratio - 1.0);
  }
  return std::sqrt(sum / groups);
}

}  // namespace hada
