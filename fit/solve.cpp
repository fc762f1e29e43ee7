#include "fit/solve.h"

#include <numeric>

#include <Eigen/Eigenvalues>
#include <ceres/ceres.h>
#include <glog/logging.h>

#include "core/error.h"
#include "core/parallel.h"

namespace hada {
namespace {

/// A `ResidualFunction` as Ceres wants to see it.
class Residuals : public ceres::CostFunction {
 public:
  Residuals(const ResidualFunction& evaluate, int size, int count) : evaluate_(evaluate) {
    set_num_residuals(count);
    mutable_parameter_block_sizes()->push_back(size);
  }

  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override {
    evaluate_(parameters[0], residuals, jacobians ? jacobians[0] : nullptr);
    // A step into numbers that are not finite is refused, and a shorter one tried.
    return std::all_of(residuals, residuals + num_residuals(),
                       [](double value) { return std::isfinite(value); });
  }

 private:
  const ResidualFunction& evaluate_;
};

Ending descend_from(const std::vector<double>& start, const std::vector<SolverBounds>& bounds,
                    int residual_count, const ResidualFunction& evaluate,
                    const SolveOptions& options) {
  Ending ending{start};
  double* packed = ending.packed.data();
  const int size = int(start.size());
  Residuals residuals(evaluate, size, residual_count);
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  problem.AddResidualBlock(&residuals, nullptr, packed);
  for (int k = 0; k < size; ++k) {
    const auto [low, high] = bounds[std::size_t(k)];
    packed[k] = std::clamp(packed[k], low, high);
    if (std::isfinite(low)) problem.SetParameterLowerBound(packed, k, low);
    if (std::isfinite(high)) problem.SetParameterUpperBound(packed, k, high);
  }
  ceres::Solver::Options how;
  how.linear_solver_type = ceres::DENSE_QR;
  how.max_num_iterations = options.max_iterations;
  how.function_tolerance = options.tolerance;
  how.parameter_tolerance = 1e-10;
  how.gradient_tolerance = 1e-12;
  how.num_threads = 1;
  how.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(how, &problem, &summary);
  // Whether it converged is not asked: only where it ended, and what that costs.
  if (summary.IsSolutionUsable() && std::isfinite(summary.final_cost))
    ending.cost = summary.final_cost;
  return ending;
}

}  // namespace

std::vector<Ending> descend(const std::vector<std::vector<double>>& starts,
                            const std::vector<SolverBounds>& bounds, int residual_count,
                            const ResidualFunction& evaluate, const SolveOptions& options) {
  FLAGS_minloglevel = google::GLOG_FATAL;  // Ceres speaks of every step that it has to refuse
  std::vector<Ending> endings(starts.size());
  for_each_index(int(starts.size()), [&](int k) {
    endings[std::size_t(k)] =
        descend_from(starts[std::size_t(k)], bounds, residual_count, evaluate, options);
  });
  if (std::all_of(endings.begin(), endings.end(),
                  [](const Ending& ending) { return !std::isfinite(ending.cost); })) {
    throw Error("fit: no start led to finite residuals; check that the map has a usable spectrum");
  }
  return endings;
}

Eigen::MatrixXd covariance_of(const Eigen::MatrixXd& information, const std::vector<bool>& free) {
  std::vector<int> kept;
  for (int k = 0; k < int(free.size()); ++k) {
    if (free[std::size_t(k)]) kept.push_back(k);
  }
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(information.rows(), information.cols());
  if (kept.empty()) return covariance;
  constexpr double unknown = 1e-12;  // the least information: a deviation of a million units
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(information(kept, kept));
  const Eigen::VectorXd variance = eigen.eigenvalues().cwiseMax(unknown).cwiseInverse();
  covariance(kept, kept) =
      eigen.eigenvectors() * variance.asDiagonal() * eigen.eigenvectors().transpose();
  return covariance;
}

}  // namespace hada
