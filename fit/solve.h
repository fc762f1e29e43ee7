#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <Eigen/Core>
#include <ceres/jet.h>

#include "core/field.h"
#include "fit/fit.h"
#include "fit/residual_function.h"

namespace hada {

struct SolveOptions {
  int max_iterations = 200;
  double tolerance = 1e-10;  // relative change of the cost at which a start is done
  double same_cost = 0.1;    // endings whose costs differ by less (or by 1e-6 of it) are one ending
};

/// Where a start ended.
struct Ending {
  std::vector<double> packed;
  double cost = HUGE_VAL;  // half the sum of squares; infinite if it left the finite numbers
};

/// The endings of bounded Levenberg-Marquardt runs, in the order of their starts, run in parallel.
std::vector<Ending> descend(const std::vector<std::vector<double>>& starts,
                            const std::vector<SolverBounds>& bounds, int residual_count,
                            const ResidualFunction& evaluate, const SolveOptions& options);

/// Covariance of the free fields from their Fisher information; rows of the others are zero.
/// A direction that nothing is known about gets a variance of 1e12 times its unit, not infinity.
Eigen::MatrixXd covariance_of(const Eigen::MatrixXd& information, const std::vector<bool>& free);

/// `residual(material, r)`, a lambda for any scalar, as a function of the packed fields.
///
/// Derivatives come from Jets of a few parts, so that the number of fields is open.
template <template <class> class M, class Residual>
ResidualFunction evaluator(const M<double>& shape, int residual_count, const Residual& residual) {
  return [=](const double* packed, double* residuals, double* jacobian) {
    if (!jacobian) return residual(unpack(shape, packed), residuals);
    // A residual that knows a shorter way to its derivatives takes it.
    if constexpr (requires { residual.evaluate(shape, packed, residuals, jacobian); }) {
      return residual.evaluate(shape, packed, residuals, jacobian);
    }
    constexpr int stride = 4;
    using Jet = ceres::Jet<double, stride>;
    const int size = int(pack(shape).size());
    std::vector<Jet> point(packed, packed + size);
    std::vector<Jet> values(std::size_t(residual_count), Jet(0.0));
    for (int first = 0; first < size; first += stride) {
      const int last = std::min(first + stride, size);
      for (int k = first; k < last; ++k) point[std::size_t(k)].v[k - first] = 1.0;
      residual(unpack(shape, point.data()), values.data());
      for (int i = 0; i < residual_count; ++i) {
        residuals[i] = values[std::size_t(i)].a;
        for (int k = first; k < last; ++k)
          jacobian[i * size + k] = values[std::size_t(i)].v[k - first];
      }
      for (int k = first; k < last; ++k) point[std::size_t(k)].v.setZero();
    }
  };
}

/// The derivatives of `residual` with respect to the packed fields of `material`, a row each.
template <template <class> class M, class Residual>
Eigen::MatrixXd jacobian_of(const M<double>& material, int residual_count,
                            const Residual& residual) {
  const auto packed = pack(material);
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  RowMajor jacobian(residual_count, packed.size());
  std::vector<double> residuals(std::size_t(residual_count), 0.0);
  evaluator(material, residual_count, residual)(packed.data(), residuals.data(), jacobian.data());
  return jacobian;
}

/// Paths of the fields of `material` that lie on one of `bounds`, as far as a solver can tell.
template <class M>
std::vector<std::string> fields_on_bound(const M& material,
                                         const std::vector<SolverBounds>& bounds) {
  std::vector<std::string> paths;
  const auto packed = pack(material);
  std::size_t k = 0;
  visit_fields(material, [&](const std::string& path, const auto&, const double&) {
    const auto [low, high] = bounds[k];
    const double near = 1e-4 * (high - low);  // infinite for a half turn, which has no bounds
    if (std::isfinite(near) && (packed[k] < low + near || packed[k] > high - near))
      paths.push_back(path);
    ++k;
  });
  return paths;
}

/// Fills on_bound, covariance and sigma of `fit` from the Fisher information of its packed fields,
/// which were sought inside `bounds`.
template <class M>
void set_uncertainty(Fit<M>& fit, const Eigen::MatrixXd& information,
                     const std::vector<SolverBounds>& bounds) {
  fit.on_bound = fields_on_bound(fit.material, bounds);
  std::vector<bool> free;
  visit_fields(fit.material, [&](const std::string& path, const auto&, const double&) {
    free.push_back(std::find(fit.on_bound.begin(), fit.on_bound.end(), path) == fit.on_bound.end());
  });
  fit.covariance = covariance_of(information, free);
  const auto packed = pack(fit.material);
  fit.sigma = fit.material;
  std::size_t k = 0;
  visit_fields(fit.sigma, [&](const std::string&, const auto& field, double& sigma) {
    const double spread = std::sqrt(fit.covariance(Eigen::Index(k), Eigen::Index(k)));
    sigma = field.scale == Scale::log ? spread * std::exp(packed[k]) : spread;
    // A direction is nowhere less known than one that may be anything.
    if (field.scale == Scale::half_turn) sigma = std::min(sigma, std::numbers::pi / std::sqrt(12));
    ++k;
  });
}

/// The same where they were sought inside the bounds of the fields.
template <class M>
void set_uncertainty(Fit<M>& fit, const Eigen::MatrixXd& information) {
  set_uncertainty(fit, information, solver_bounds_of(fit.material));
}

/// Where each start ends, in the order of the starts, with its cost.
template <template <class> class M, class Residual>
std::vector<Ending> endings_of(const std::vector<M<double>>& starts,
                               const std::vector<SolverBounds>& bounds, int residual_count,
                               const Residual& residual, const SolveOptions& options) {
  std::vector<std::vector<double>> packed;
  for (const auto& start : starts) packed.push_back(pack(start));
  return descend(packed, bounds, residual_count,
                 evaluator(starts.front(), residual_count, residual), options);
}

/// The same with the bounds of the fields.
template <template <class> class M, class Residual>
std::vector<Ending> endings_of(const std::vector<M<double>>& starts, int residual_count,
                               const Residual& residual, const SolveOptions& options = {}) {
  return endings_of(starts, solver_bounds_of(starts.front()), residual_count, residual, options);
}

/// The material whose residuals are smallest, from several starts.
///
/// starts    at least one, all with lists of the same lengths
/// residual  `[&](const auto& material, auto* r)` fills residual_count whitened residuals, for any
///           scalar; called from several threads
/// returns   the best ending (the first of equals), its gap to the runner-up, and sigma from J^T J
/// throws    Error if no start leads to finite residuals
template <template <class> class M, class Residual>
Fit<M<double>> solve(const std::vector<M<double>>& starts, int residual_count,
                     const Residual& residual, const SolveOptions& options = {}) {
  const auto endings = endings_of(starts, residual_count, residual, options);
  const auto best =
      std::min_element(endings.begin(), endings.end(),
                       [](const Ending& a, const Ending& b) { return a.cost < b.cost; });
  Fit<M<double>> fit;
  fit.material = unpack(starts.front(), best->packed.data());
  fit.cost = best->cost;
  fit.starts = int(starts.size());
  fit.runner_up_gap = HUGE_VAL;
  const double same = std::max(options.same_cost, 1e-6 * fit.cost);
  for (const auto& ending : endings) {
    const double gap = ending.cost - fit.cost;
    if (gap <= same) {
      ++fit.agreeing;
    } else {
      fit.runner_up_gap = std::min(fit.runner_up_gap, gap);
    }
  }
  const auto jacobian = jacobian_of(fit.material, residual_count, residual);
  set_uncertainty(fit, jacobian.transpose() * jacobian);
  return fit;
}

}  // namespace hada
