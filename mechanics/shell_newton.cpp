#include "mechanics/shell_newton.h"

#include <algorithm>
#include <cmath>

#include <Eigen/SparseCholesky>

#include "mechanics/newton_way.h"

namespace hada {
namespace {

using Eigen::Matrix3d, Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr int worth_factors = 30;  // directions that cost about what new factors do

Sparse symmetric_net(const ShellNet& net, const ShellSprings& s, const KnitFrames& frames,
                     double drag) {
  const int b = frames.free, n = net.points();
  std::vector<Matrix3d> own(std::size_t(n), drag * Matrix3d::Identity());
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](int row, int col, const Eigen::MatrixXd& block) {
    for (int r = 0; r < b; ++r) {
      for (int c = 0; c < b; ++c) {
        if (b * row + r >= b * col + c) entries.emplace_back(b * row + r, b * col + c, block(r, c));
      }
    }
  };
  for (int k = 0; k < int(net.springs.size()); ++k) {
    const auto p = std::size_t(k);
    const auto [from, to, course, before, after] = net.springs[p];
    const double c = k < net.along ? net.continuity : 0.0;
    const Matrix3d stiffness = pulling_stiffness(s.directions[p], (1.0 + 3.0 * c) * s.stiffness[p],
                                                 (1.0 + c) * s.tension[p], s.length[p]);
    own[std::size_t(from)] += stiffness, own[std::size_t(to)] += stiffness;
    if (net.is_pinned(from) || net.is_pinned(to)) continue;
    const int high = std::max(from, to), low = std::min(from, to);
    add(high, low,
        -(frames.axes[std::size_t(high)].leftCols(b).transpose() * stiffness *
          frames.axes[std::size_t(low)].leftCols(b)));
  }
  for (int i = 0; i < n; ++i) {
    const auto& axes = frames.axes[std::size_t(i)].leftCols(b);
    add(i, i,
        net.is_pinned(i) ? Eigen::MatrixXd(Eigen::MatrixXd::Identity(b, b))
                         : Eigen::MatrixXd(axes.transpose() * own[std::size_t(i)] * axes));
  }
  Sparse matrix(b * n, b * n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

struct ShellNewton::Factors {
  Eigen::SimplicialLDLT<Sparse> ldlt;
  bool fresh = false;
  double drag = 0.0;
};

ShellNewton::ShellNewton() : factors_(std::make_unique<Factors>()) {}
ShellNewton::~ShellNewton() = default;

Places ShellNewton::step(const ShellNet& net, const ShellSprings& springs, const KnitFrames& frames,
                         const Places& load, double tolerance, double drag) {
  Factors& f = *factors_;
  if (!f.fresh || drag != f.drag) {
    const Sparse matrix = symmetric_net(net, springs, frames, drag);
    // Which entries there are depends on which points stay.
    f.ldlt.compute(matrix);
    f.drag = drag;
  }
  const auto solved = newton_way(net, springs, frames, load, tolerance, drag,
                                 [&](const VectorXd& x) -> VectorXd { return f.ldlt.solve(x); });
  f.fresh = solved.directions <= worth_factors;
  return in_space(frames, net.pinned, solved.x);
}

}  // namespace hada
