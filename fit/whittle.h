#pragma once

#include <cmath>
#include <vector>

#include "core/scalar.h"
#include "fit/cells.h"
#include "synth/wrinkle.h"

namespace hada {

/// Whether derivatives are asked for with respect to anything that made this covariance.
template <class T>
bool varies(const GaussianCovariance<T>& covariance) {
  if constexpr (requires { covariance.variance.v; }) {
    return !(covariance.variance.v.isZero() && covariance.xx.v.isZero() &&
             covariance.xy.v.isZero() && covariance.yy.v.isZero());
  } else {
    return true;
  }
}

/// Adds what one component sends into every cell.
template <class T, class U>
void add_density(std::vector<T>& sums, const GaussianCovariance<U>& covariance,
                 const std::vector<Cell>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    const GaussianCovariance<U> seen{covariance.variance, covariance.xx + cell.xx,
                                     covariance.xy + cell.xy, covariance.yy + cell.yy};
    sums[i] += psd(seen, cell.fx, cell.fy);
  }
}

/// The expected power of every cell.
template <class T>
std::vector<T> densities(const Wrinkle<T>& wrinkle, const std::vector<Cell>& cells) {
  std::vector<T> sums(cells.size(), wrinkle.floor_mm4);
  for (const auto& component : wrinkle.components) {
    const auto covariance = autocovariance(component);
    if (varies(covariance)) {
      add_density(sums, covariance, cells);
    } else {
      // Derivatives are taken a few fields at a time: most components stand still meanwhile.
      const GaussianCovariance<> still{value_of(covariance.variance), value_of(covariance.xx),
                                       value_of(covariance.xy), value_of(covariance.yy)};
      add_density(sums, still, cells);
    }
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
    sums[i] = sums[i] * cells[i].correction + cells[i].leakage + cells[i].noise;
  return sums;
}

/// A residual whose square grows with the logarithm of r^2 beyond `scale`.
template <class T>
T softened(const T& r, double scale) {
  using std::log;
  using std::sqrt;
  const T u = r * r / (scale * scale);
  if (value_of(u) < 1e-6) return r;
  return (value_of(r) < 0.0 ? -scale : scale) * sqrt(log(1.0 + u));
}

/// sign(d) sqrt(2 (e^d - 1 - d)): half its square is the deviance of an exponential variable whose
/// logarithm exceeds that of its mean by d.
template <class T>
T deviance_residual(const T& d) {
  using std::exp;
  using std::sqrt;
  const double plain = value_of(d);
  // Near 0 by its series, where the difference would cancel; the next term is d^5 / 2520.
  if (std::abs(plain) < 0.1) {
    return d * sqrt(1.0 + d * (1.0 / 3.0 + d * (1.0 / 12.0 + d * (1.0 / 60.0 + d / 360.0))));
  }
  const T root = sqrt(2.0 * (exp(d) - 1.0 - d));
  return plain < 0.0 ? -root : root;
}

/// Forgiving log ratios, for starts that are far away.
inline auto log_ratios(const std::vector<Cell>& cells, double independence) {
  return [&cells, independence](const auto& wrinkle, auto* r) {
    using std::log;
    constexpr double cauchy_scale = 3.0;  // deviations beyond which a cell loses its say
    const auto model = densities(wrinkle, cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double n = cells[i].count;
      const double bias = 1.0 / (2.0 * n) + 1.0 / (12.0 * n * n);  // of the log of a mean of n
      r[i] =
          softened(std::sqrt(independence * n) * (std::log(cells[i].power) + bias - log(model[i])),
                   cauchy_scale);
    }
  };
}

/// Half the sum of squares is the negative logarithm of the Whittle likelihood.
inline auto deviances(const std::vector<Cell>& cells, double independence) {
  return [&cells, independence](const auto& wrinkle, auto* r) {
    using std::log;
    const auto model = densities(wrinkle, cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      r[i] = std::sqrt(independence * cells[i].count) *
             deviance_residual(std::log(cells[i].power) - log(model[i]));
    }
  };
}

/// sqrt(kappa n) ln S: the Jacobian J of this has the Fisher information J^T J.
inline auto whitened_logarithms(const std::vector<Cell>& cells, double independence) {
  return [&cells, independence](const auto& wrinkle, auto* r) {
    using std::log;
    const auto model = densities(wrinkle, cells);
    for (std::size_t i = 0; i < cells.size(); ++i)
      r[i] = std::sqrt(independence * cells[i].count) * log(model[i]);
  };
}

}  // namespace hada
