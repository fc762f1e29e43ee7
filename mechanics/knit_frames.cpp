#include "mechanics/knit_frames.h"

#include <algorithm>

namespace hada {
namespace {

// What a slack spring resists sideways, as a share of its stiffness: none would be singular.
constexpr double slack = 1e-3;

bool is_pinned(const std::vector<bool>& pinned, std::size_t point) {
  return !pinned.empty() && pinned[point];
}

}  // namespace

Eigen::VectorXd within(const KnitFrames& frames, const std::vector<bool>& pinned,
                       const Places& vectors) {
  const int b = frames.free;
  Eigen::VectorXd packed = Eigen::VectorXd::Zero(b * Eigen::Index(vectors.size()));
  for (std::size_t p = 0; p < vectors.size(); ++p) {
    if (is_pinned(pinned, p)) continue;
    packed.segment(b * Eigen::Index(p), b) = frames.axes[p].leftCols(b).transpose() * vectors[p];
  }
  return packed;
}

Places in_space(const KnitFrames& frames, const std::vector<bool>& pinned,
                const Eigen::VectorXd& packed) {
  const int b = frames.free;
  Places vectors(frames.axes.size(), Eigen::Vector3d::Zero());
  for (std::size_t p = 0; p < vectors.size(); ++p) {
    if (is_pinned(pinned, p)) continue;
    vectors[p] = frames.axes[p].leftCols(b) * packed.segment(b * Eigen::Index(p), b);
  }
  return vectors;
}

Eigen::Matrix3d pulling_stiffness(const Eigen::Vector3d& u, double k, double tension,
                                  double length) {
  const double across = std::max(tension / length, slack * k);
  return across * Eigen::Matrix3d::Identity() + (k - across) * u * u.transpose();
}

}  // namespace hada
