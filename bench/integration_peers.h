#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/SparseCore>

#include "bench/integration_study.h"

namespace hada {

/// The normal equations of a scene, for solvers that want a matrix.
struct IntegrationProblem {
  Grid<int> unknown;  // of a pixel, -1 outside the mask
  int unknowns = 0;
  std::vector<std::pair<int, int>> edges;
  std::vector<double> right;
  std::vector<int> tied;  // one unknown of every region
};

IntegrationProblem problem_of(const IntegrationScene& scene);
/// The Laplacian; tied: regular, with one pixel of every region held at 0.
Eigen::SparseMatrix<double> matrix_of(const IntegrationProblem& problem, bool tied);
double error_px(const IntegrationScene& scene, const Grid<float>& height);
/// collect  given: makes the height of what `solve` left elsewhere, outside of the time
SolverRun timed(const std::string& solver, const IntegrationScene& scene,
                const std::function<std::vector<double>(const IntegrationProblem&)>& solve,
                const std::function<std::vector<double>()>& collect = {});

}  // namespace hada
