#include "mechanics/knit_newton.h"

#include <algorithm>

#include <Eigen/Jacobi>

#include "core/parallel.h"

namespace hada {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int most_directions = 80;  // of GMRES, before it starts again
constexpr int most_rounds = 4;
constexpr int worth_factors = 14;  // directions that cost about what new factors do

// What a slack spring resists sideways, as a share of its stiffness: none would be singular.
constexpr double slack = 1e-3;

// The stiffness of a spring between its ends, without the push of one that is slack.
Matrix3d stiffness_of(const Vector3d& u, double k, double tension, double length) {
  const double across = std::max(tension / length, slack * k);
  return across * Matrix3d::Identity() + (k - across) * u * u.transpose();
}

VectorXd within(const KnitNet& net, const KnitFrames& frames, const Places& vectors) {
  const int b = frames.free;
  VectorXd packed = VectorXd::Zero(b * net.points());
  for (int i = 0; i < net.points(); ++i) {
    if (net.is_pinned(i)) continue;
    const auto p = std::size_t(i);
    packed.segment(b * i, b) = frames.axes[p].leftCols(b).transpose() * vectors[p];
  }
  return packed;
}

Places in_space(const KnitNet& net, const KnitFrames& frames, const VectorXd& packed) {
  const int b = frames.free;
  Places vectors(std::size_t(net.points()), Vector3d::Zero());
  for (int i = 0; i < net.points(); ++i) {
    if (net.is_pinned(i)) continue;
    const auto p = std::size_t(i);
    vectors[p] = frames.axes[p].leftCols(b) * packed.segment(b * i, b);
  }
  return vectors;
}

struct Solved {
  VectorXd x;
  int directions = 0;
  double left = 1.0;  // residual over the right side
};

// x with apply(x) = right side; `precondition` is close to the inverse of `apply`.
template <class Apply, class Precondition>
Solved gmres(const Apply& apply, const Precondition& precondition, const VectorXd& right_side,
             double tolerance) {
  Solved solved{VectorXd::Zero(right_side.size())};
  const double size = right_side.norm();
  if (size == 0.0) return solved;
  VectorXd residual = right_side;
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<VectorXd> basis{residual / residual.norm()};
    Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(most_directions + 1, most_directions);
    VectorXd goal = VectorXd::Zero(most_directions + 1), weights;
    goal[0] = residual.norm();
    std::vector<Eigen::JacobiRotation<double>> turns;
    int k = 0;
    for (; k < most_directions && std::abs(goal[k]) > tolerance * size; ++k) {
      VectorXd next = apply(precondition(basis.back()));
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
    VectorXd sum = VectorXd::Zero(right_side.size());
    for (int j = 0; j < k; ++j) sum += weights[j] * basis[std::size_t(j)];
    solved.x += precondition(sum);
    solved.left = std::abs(goal[k]) / size;
    if (solved.left <= tolerance) break;
    residual = right_side - apply(solved.x);
  }
  return solved;
}

}  // namespace

KnitNewton::KnitNewton(const KnitNet& net, int free)
    : matrix_(net.courses, net.wales, net.round, free),
      factors_(net.courses, net.wales, net.round) {}

void KnitNewton::factorize(const KnitNet& net, const KnitSprings& s, const KnitFrames& frames,
                           double drag) {
  const int b = frames.free, n = net.points(), w = net.wales;
  matrix_.own.setZero(), matrix_.right.setZero(), matrix_.up.setZero();
  std::vector<Matrix3d> own(std::size_t(n), drag * Matrix3d::Identity());
  const auto couple = [&](int from, int to, const Matrix3d& stiffness, Eigen::MatrixXd& blocks) {
    own[std::size_t(from)] += stiffness, own[std::size_t(to)] += stiffness;
    if (net.is_pinned(from) || net.is_pinned(to)) return;
    const auto& a = frames.axes[std::size_t(from)].leftCols(b);
    const auto& c = frames.axes[std::size_t(to)].leftCols(b);
    matrix_.at(blocks, from) = -(a.transpose() * stiffness * c);
  };
  for (int i = 0; i < n; ++i) {
    const auto p = std::size_t(i);
    const double k = net.stiffness[std::size_t(i / w)], c = net.continuity;
    const int wale = i % w;
    if (wale + 1 < w || net.round) {
      const int right = i - wale + (wale + 1) % w;
      couple(i, right,
             stiffness_of(s.along[p], (1.0 + 3.0 * c) * k, (1.0 + c) * s.along_tension[p],
                          s.along_length[p]),
             matrix_.right);
    }
    if (i + w < n) {
      couple(i, i + w, stiffness_of(s.up[p], k, s.up_tension[p], s.up_length[p]), matrix_.up);
    }
  }
  for (int i = 0; i < n; ++i) {
    const auto& a = frames.axes[std::size_t(i)].leftCols(b);
    matrix_.at(matrix_.own, i) = net.is_pinned(i)
                                     ? Eigen::MatrixXd(Eigen::MatrixXd::Identity(b, b))
                                     : Eigen::MatrixXd((a.transpose() * own[std::size_t(i)] * a));
  }
  factors_.factorize(matrix_);
}

Places KnitNewton::step(const KnitNet& net, const KnitSprings& springs, const KnitFrames& frames,
                        const Places& load, double tolerance, double drag) {
  if (!fresh_ || drag != drag_) factorize(net, springs, frames, drag);
  drag_ = drag;
  const auto apply = [&](const VectorXd& x) -> VectorXd {
    const Places way = in_space(net, frames, x);
    Places change = force_changes(net, springs, way);
    for (std::size_t i = 0; i < frames.turning.size(); ++i) change[i] += frames.turning[i] * way[i];
    return within(net, frames, change) - drag * x;
  };
  const auto solved = gmres(
      apply, [&](const VectorXd& x) -> VectorXd { return -factors_.solve(x); },
      within(net, frames, load), tolerance);
  fresh_ = solved.directions <= worth_factors;
  return in_space(net, frames, solved.x);
}

}  // namespace hada
