#pragma once

#include <vector>

#include "mechanics/knit_net.h"

namespace hada {

/// The directions in which each point may move: the first `free` columns, of unit length and
/// perpendicular. On a surface they are two tangents.
struct KnitFrames {
  int free = 2;
  std::vector<Eigen::Matrix3d> axes;
  // What the force within the frame changes by, besides J, because the frame turns as its point
  // moves; empty: frames stay as they are.
  std::vector<Eigen::Matrix3d> turning = {};
};

/// Vectors of points as numbers along their axes, point after point; 0 for those that are pinned.
Eigen::VectorXd within(const KnitFrames& frames, const std::vector<bool>& pinned,
                       const Places& vectors);
/// The other way round.
Places in_space(const KnitFrames& frames, const std::vector<bool>& pinned,
                const Eigen::VectorXd& packed);

/// How a spring of direction `u` resists a move of one of its ends, without the push of one that is
/// slack: that would make no definite matrix.
Eigen::Matrix3d pulling_stiffness(const Eigen::Vector3d& u, double k, double tension,
                                  double length);

}  // namespace hada
