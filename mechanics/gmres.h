#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Jacobi>

namespace hada {

struct GmresSolution {
  Eigen::VectorXd x;
  int directions = 0;
  double left = 1.0;  // residual over the right side
};

/// x with apply(x) = right side, to a residual of `tolerance` times it; `precondition` is close to
/// the inverse of `apply`.
///
/// Source: Saad and Schultz, GMRES, SIAM J. Sci. Stat. Comput. 7 (1986), preconditioned from the
/// right.
template <class Apply, class Precondition>
GmresSolution gmres(const Apply& apply, const Precondition& precondition,
                    const Eigen::VectorXd& right_side, double tolerance) {
  GmresSolution solved{Eigen::VectorXd::Zero(right_side.size())};
  const double size = right_side.norm();
  constexpr int most_directions = 80;  // before it starts again
  constexpr int most_rounds = 4;
  if (size == 0.0) return solved;
  Eigen::VectorXd residual = right_side;
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<Eigen::VectorXd> basis{residual / residual.norm()};
    Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(most_directions + 1, most_directions);
    Eigen::VectorXd goal = Eigen::VectorXd::Zero(most_directions + 1), weights;
    goal[0] = residual.norm();
    std::vector<Eigen::JacobiRotation<double>> turns;
    int k = 0;
    for (; k < most_directions && std::abs(goal[k]) > tolerance * size; ++k) {
      Eigen::VectorXd next = apply(precondition(basis.back()));
      for (int j = 0; j <= k; ++j) {
        hessenberg(j, k) = next.dot(basis[std::size_t(j)]);
        next -= hessenberg(j, k) * basis[std::size_t(j)];
      }
      hessenberg(k + 1, k) = next.norm();
      basis.push_back(next / std::max(hessenberg(k + 1, k), 1e-300));
      for (int j = 0; j < k; ++j) {
        hessenberg.col(k).applyOnTheLeft(j, j + 1, turns[std::size_t(j)].adjoint());
      }
      Eigen::JacobiRotation<double> turn;
      turn.makeGivens(hessenberg(k, k), hessenberg(k + 1, k));
      hessenberg.col(k).applyOnTheLeft(k, k + 1, turn.adjoint());
      goal.applyOnTheLeft(k, k + 1, turn.adjoint());
      turns.push_back(turn);
    }
    solved.directions += k;
    weights = hessenberg.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(goal.head(k));
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(right_side.size());
    for (int j = 0; j < k; ++j) sum += weights[j] * basis[std::size_t(j)];
    solved.x += precondition(sum);
    solved.left = std::abs(goal[k]) / size;
    if (solved.left <= tolerance) break;
    residual = right_side - apply(solved.x);
  }
  return solved;
}

}  // namespace hada
