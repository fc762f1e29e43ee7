#pragma once

#include <vector>

#include "mechanics/grid_cholesky.h"
#include "mechanics/knit_frames.h"

namespace hada {

/// Newton's steps of a knit: where its forces would vanish if they changed as they begin to.
///
/// The Jacobian J is not symmetric, since eq. 2 has no counterforce, and couples points two wales
/// apart. It is never formed: GMRES applies `force_changes`, preconditioned by the factors of the
/// symmetric net whose yarns are 1 + 3 c times as stiff along, which a slowly changing J looks
/// like.
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
