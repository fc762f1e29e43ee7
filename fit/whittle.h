#pragma once

#include <cmath>
#include <vector>

#include <ceres/jet.h>

#include "core/field.h"
#include "core/scalar.h"
#include "fit/cells.h"
#include "synth/wrinkle.h"

namespace hada {

/// What one component sends into a cell.
template <class T>
T density_in(const Cell& cell, const GaussianCovariance<T>& covariance) {
  const GaussianCovariance<T> seen{covariance.variance, covariance.xx + cell.xx,
                                   covariance.xy + cell.xy, covariance.yy + cell.yy};
  return psd(seen, cell.fx, cell.fy);
}

/// What arrives of the power that all components and the floor send.
template <class T>
T received(const Cell& cell, const T& sent) {
  return sent * cell.correction + (cell.leakage + cell.noise);
}

/// The expected power of every cell.
template <class T>
std::vector<T> densities(const Wrinkle<T>& wrinkle, const std::vector<Cell>& cells) {
  std::vector<T> sums(cells.size(), wrinkle.floor_mm4);
  for (const auto& component : wrinkle.components) {
    const auto covariance = autocovariance(component);
    for (std::size_t i = 0; i < cells.size(); ++i) sums[i] += density_in(cells[i], covariance);
  }
  for (std::size_t i = 0; i < cells.size(); ++i) sums[i] = received(cells[i], sums[i]);
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

/// Residuals of a wrinkle, one for each cell: a function of its measured and its expected power.
///
/// The derivatives are those that `evaluator` would find for any material, but each component is
/// looked at once, and not again while those of the others are taken.
template <class OfPower>
class CellResiduals {
 public:
  CellResiduals(const std::vector<Cell>& cells, const OfPower& of_power)
      : cells_(cells), of_power_(of_power) {}

  template <class T>
  void operator()(const Wrinkle<T>& wrinkle, T* r) const {
    const auto model = densities(wrinkle, cells_);
    for (std::size_t i = 0; i < cells_.size(); ++i) r[i] = of_power_(cells_[i], model[i]);
  }

  /// The residuals at `packed` and their derivatives, a row each.
  void evaluate(const Wrinkle<>& shape, const double* packed, double* residuals,
                double* jacobian) const {
    constexpr int stride = 4;  // fields of a component
    using Jet = ceres::Jet<double, stride>;
    const int parts = int(shape.components.size());
    const int fitted = stride * parts + 1;                          // those that the spectrum knows
    const int size = fitted + int(Wrinkle<>::fields().size()) - 1;  // ridges leave it alone
    std::vector<Jet> point(packed, packed + size);
    const auto moving = [&](int first, int count, const auto& use) {
      for (int k = 0; k < count; ++k) point[std::size_t(first + k)].v[k] = 1.0;
      use(unpack(shape, point.data()));
      for (int k = 0; k < count; ++k) point[std::size_t(first + k)].v.setZero();
    };
    std::vector<double> sent(cells_.size(), 0.0);
    for (int part = 0; part < parts; ++part) {
      moving(stride * part, stride, [&](const Wrinkle<Jet>& wrinkle) {
        const auto covariance = autocovariance(wrinkle.components[std::size_t(part)]);
        for (std::size_t i = 0; i < cells_.size(); ++i) {
          const Jet density = density_in(cells_[i], covariance);
          sent[i] += density.a;
          for (int k = 0; k < stride; ++k) {
            jacobian[int(i) * size + stride * part + k] = density.v[k];
          }
        }
      });
    }
    moving(fitted - 1, 1, [&](const Wrinkle<Jet>& wrinkle) {
      for (std::size_t i = 0; i < cells_.size(); ++i) {
        sent[i] += wrinkle.floor_mm4.a;
        jacobian[int(i) * size + fitted - 1] = wrinkle.floor_mm4.v[0];
        for (int k = fitted; k < size; ++k) jacobian[int(i) * size + k] = 0.0;
      }
    });
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const ceres::Jet<double, 1> power(sent[i], 0);
      const auto residual = of_power_(cells_[i], received(cells_[i], power));
      residuals[i] = residual.a;
      for (int k = 0; k < size; ++k) jacobian[int(i) * size + k] *= residual.v[0];
    }
  }

 private:
  const std::vector<Cell>& cells_;
  OfPower of_power_;
};

/// By how much the logarithm of the mean of `n` exponential numbers falls short of that of their
/// expectation, on average; the next term is of the fourth order.
inline double bias_of_log_mean(double n) {
  return 1.0 / (2.0 * n) + 1.0 / (12.0 * n * n);
}

/// Forgiving log ratios, for starts that are far away.
inline auto log_ratios(const std::vector<Cell>& cells, double independence) {
  return CellResiduals(cells, [independence](const Cell& cell, const auto& model) {
    using std::log;
    constexpr double cauchy_scale = 3.0;  // deviations beyond which a cell loses its say
    const double n = cell.count;
    return softened(
        std::sqrt(independence * n) * (std::log(cell.power) + bias_of_log_mean(n) - log(model)),
        cauchy_scale);
  });
}

/// Half the sum of squares is the negative logarithm of the Whittle likelihood.
inline auto deviances(const std::vector<Cell>& cells, double independence) {
  return CellResiduals(cells, [independence](const Cell& cell, const auto& model) {
    using std::log;
    return std::sqrt(independence * cell.count) *
           deviance_residual(std::log(cell.power) - log(model));
  });
}

/// sqrt(kappa n) ln S: the Jacobian J of this has the Fisher information J^T J.
inline auto whitened_logarithms(const std::vector<Cell>& cells, double independence) {
  return CellResiduals(cells, [independence](const Cell& cell, const auto& model) {
    using std::log;
    return std::sqrt(independence * cell.count) * log(model);
  });
}

}  // namespace hada
