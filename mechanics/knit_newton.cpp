#include "mechanics/knit_newton.h"

#include <algorithm>

#include "core/parallel.h"
#include "mechanics/newton_way.h"

namespace hada {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int worth_factors = 14;  // directions that cost about what new factors do

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
             pulling_stiffness(s.along[p], (1.0 + 3.0 * c) * k, (1.0 + c) * s.along_tension[p],
                               s.along_length[p]),
             matrix_.right);
    }
    if (i + w < n) {
      couple(i, i + w, pulling_stiffness(s.up[p], k, s.up_tension[p], s.up_length[p]), matrix_.up);
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
  const auto solved = newton_way(net, springs, frames, load, tolerance, drag,
                                 [&](const VectorXd& x) -> VectorXd { return factors_.solve(x); });
  fresh_ = solved.directions <= worth_factors;
  return in_space(frames, net.pinned, solved.x);
}

}  // namespace hada
