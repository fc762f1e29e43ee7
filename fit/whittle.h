#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <ceres/jet.h>

#include "core/field.h"
#include "core/scalar.h"
#include "fit/cells.h"
#include "synth/wrinkle.h"

namespace hada {

/// What a noise function of some autocovariance sends into cells, one after the other: those of one
/// shape see it through one window, which is laid over it once.
template <class Covariance>
class DensityIn {
 public:
  explicit DensityIn(const Covariance& covariance)
      : covariance_(covariance), density_(density_of(covariance)) {}

  auto operator()(const Cell& cell) {
    if (cell.xx != window_.xx || cell.xy != window_.xy || cell.yy != window_.yy) {
      window_ = {cell.xx, cell.xy, cell.yy};
      density_ = density_of(narrowed(covariance_, window_));
    }
    return density_(cell.fx, cell.fy);
  }

 private:
  Covariance covariance_;
  GaussianWindow window_;
  decltype(density_of(std::declval<Covariance>())) density_;
};

/// What arrives of the power that all components and the floor send.
template <class T>
T received(const Cell& cell, const T& sent) {
  return sent * cell.correction + (cell.leakage + cell.noise);
}

/// The expected power of every cell.
template <class T>
std::vector<T> densities(const Wrinkle<T>& wrinkle, const std::vector<Cell>& cells) {
  std::vector<T> sums(cells.size(), wrinkle.floor_mm4);
  for_each_noise(wrinkle, [&](const auto& noise) {
    DensityIn density(autocovariance(noise));
    for (std::size_t i = 0; i < cells.size(); ++i) sums[i] += density(cells[i]);
  });
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

/// Packed fields as dual numbers, each a direction of its own.
template <int fields>
std::array<ceres::Jet<double, fields>, std::size_t(fields)> seeded(const double* packed) {
  std::array<ceres::Jet<double, fields>, std::size_t(fields)> point;
  for (int k = 0; k < fields; ++k) point[std::size_t(k)] = {packed[k], k};
  return point;
}

/// Residuals of a wrinkle, one for each cell: a function of its measured and its expected power.
///
/// The derivatives are those that `evaluator` would find for any material, but each component is
/// looked at once, and not again while those of the others are taken.
template <class OfPower>
class CellResiduals {
 public:
  /// cells       stay where they are: they are looked at in every evaluation
  /// say_of_all  weight of one more residual, the last: the logarithm of the measured over the
  ///             expected power of all cells together; 0: none
  CellResiduals(const std::vector<Cell>& cells, const OfPower& of_power, double say_of_all = 0.0)
      : cells_(cells), of_power_(of_power), say_of_all_(say_of_all) {}

  int count() const { return int(cells_.size()) + (say_of_all_ > 0.0 ? 1 : 0); }

  template <class T>
  void operator()(const Wrinkle<T>& wrinkle, T* r) const {
    const auto model = densities(wrinkle, cells_);
    for (std::size_t i = 0; i < cells_.size(); ++i) r[i] = of_power_(cells_[i], model[i]);
    if (say_of_all_ == 0.0) return;
    using std::log;
    T expected(0.0);
    double measured = 0.0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      expected += double(cells_[i].count) * model[i];
      measured += cells_[i].count * cells_[i].power;
    }
    r[cells_.size()] = say_of_all_ * log(measured / expected);
  }

  /// The residuals at `packed` and their derivatives, a row each.
  void evaluate(const Wrinkle<>& shape, const double* packed, double* residuals,
                double* jacobian) const {
    const int size = int(pack(shape).size());
    Sums sums{std::vector<double>(cells_.size(), 0.0), jacobian, size};
    int first = 0;  // of the fields of a part
    for_each_noise(shape, [&](const auto& noise) { first += add(noise, packed, first, sums); });
    std::vector<ceres::Jet<double, 1>> point(packed, packed + size);
    point[std::size_t(first)].v[0] = 1.0;
    const auto floor = unpack(shape, point.data()).floor_mm4;
    double* const last = jacobian + std::ptrdiff_t(cells_.size()) * size;
    if (say_of_all_ > 0.0) std::fill(last, last + size, 0.0);
    double expected = 0.0, measured = 0.0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const Cell& cell = cells_[i];
      double* const row = jacobian + std::ptrdiff_t(i) * size;
      row[first] = floor.v[0];
      std::fill(row + first + 1, row + size, 0.0);  // ridges leave the spectrum alone
      const ceres::Jet<double, 1> sent(sums.sent[i] + floor.a, 0);
      const auto power = received(cell, sent);
      const auto residual = of_power_(cell, power);
      residuals[i] = residual.a;
      expected += cell.count * power.a;
      measured += cell.count * cell.power;
      if (say_of_all_ > 0.0)
        for (int k = 0; k < size; ++k) last[k] += cell.count * power.v[0] * row[k];
      for (int k = 0; k < size; ++k) row[k] *= residual.v[0];
    }
    if (say_of_all_ == 0.0) return;
    residuals[cells_.size()] = say_of_all_ * std::log(measured / expected);
    for (int k = 0; k < size; ++k) last[k] *= -say_of_all_ / expected;
  }

 private:
  struct Sums {
    std::vector<double> sent;  // power by cell
    double* jacobian;          // its derivatives, rows of `size`
    int size;
  };

  /// What a part sends, and its derivatives by its fields, the first of which is `first` of
  /// `packed`. Returns the number of its fields.
  template <template <class> class Part>
  int add(const Part<double>& part, const double* packed, int first, Sums& sums) const {
    constexpr int fields = int(Part<double>::fields().size());
    DensityIn density_in(autocovariance(unpack(part, seeded<fields>(packed + first).data())));
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const auto density = density_in(cells_[i]);
      sums.sent[i] += density.a;
      double* const row = sums.jacobian + std::ptrdiff_t(i) * sums.size;
      for (int k = 0; k < fields; ++k) row[first + k] = density.v[k];
    }
    return fields;
  }

  const std::vector<Cell>& cells_;
  OfPower of_power_;
  double say_of_all_;
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
