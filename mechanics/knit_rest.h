#pragma once

#include "mechanics/knit_net.h"

namespace hada {

struct KnitRestOptions {
  int most_steps = 200;
  double tolerance = 1e-7;  // of a step, in wale lengths, where it ends: the next would be a
                            // thousandth of that
};

struct KnitAtRest {
  Places places;
  int steps = 0;
  double last_step = 0.0;   // of any point, in wale lengths
  double force_left = 0.0;  // the largest on a free point, over the largest tension
  bool settled = false;     // false: the search ended before; what is known is the best so far
};

/// Where the points of a knit come to rest: all forces on free points vanish.
///
/// Newton's method; where a step would lead uphill, points are dragged as if in a thick liquid that
/// thins as the forces fall (pseudo-transient continuation, Kelley and Keyes, SIAM J. Numer. Anal.
/// 35, 1998). It finds the same rest as the paper's motion without its slow end, which takes some
/// n^2 steps on a net of n points a side. A wide net held by single points may hang slack between
/// them; its rest is then nearly free to move, and may not be found in `most_steps`.
///
/// start   places near the rest, pinned points where they stay; all with z = 0 for a flat net,
///         which stays flat
/// throws  Error if places, stiffness and pins are not as many as the net says, or the net has
///         fewer than 3 wales or 2 courses
KnitAtRest knit_at_rest(const KnitNet& net, Places start, const KnitRestOptions& options = {});

/// Throws as `knit_at_rest` does.
void expect_whole(const KnitNet& net, const Places& places);

}  // namespace hada
