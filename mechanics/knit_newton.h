#pragma once

#include <vector>

#include "mechanics/grid_cholesky.h"
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

/// Newton's steps of a knit: where its forces would vanish if they changed as they begin to.
///
/// The Jacobian J is not symmetric, since eq. 2 has no counterforce, and couples points two wales
/// apart. It is never formed: GMRES applies `force_changes`, preconditioned by the factors of the
/// symmetric net whose yarns are 1 + 3 c times as stiff along, which a slowly changing J looks
/// like.
///
/// Source: Saad and Schultz, GMRES, SIAM J. Sci. Stat. Comput. 7 (1986), preconditioned from the
/// right.
class KnitNewton {
 public:
  KnitNewton(const KnitNet& net, int free);

  /// The way s of the points with (J - drag) s = load within `frames`, to a residual of `tolerance`
  /// times the load; pinned points have none.
  /// Not a number where nothing holds some point.
  Places step(const KnitNet& net, const KnitSprings& springs, const KnitFrames& frames,
              const Places& load, double tolerance, double drag = 0.0);

 private:
  void factorize(const KnitNet& net, const KnitSprings& springs, const KnitFrames& frames,
                 double drag);

  GridMatrix matrix_;
  GridCholesky factors_;
  double drag_ = 0.0;   // in the factors
  bool fresh_ = false;  // the factors are of springs that are much like those to come
};

}  // namespace hada
