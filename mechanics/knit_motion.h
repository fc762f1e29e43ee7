#pragma once

#include "mechanics/knit_net.h"

namespace hada {

struct KnitMotionOptions {
  double time_step = 0.1;
  double damping = 0.07;  // share of its speed that a point loses in a step
  int most_steps = 100000;
  double still = 1e-3;  // in wale lengths: the motion in a step below which the knit has settled
};

struct KnitMotion {
  Places places;
  std::vector<double> motion;  // after each step: the longest of any point, in wale lengths
  bool settled = false;        // whether the last was below `still`; slow is not at rest
};

/// The knit as the paper moves it: v += F dt, v *= 1 - damping, x += v dt, with masses of 1, until
/// no point moves by more than `still` in a step.
///
/// The paper gives dt and says that "a damper" takes speed away; how much, it does not say. The
/// default settles its patch of 10 x 10 in the 100 steps that it reports.
///
/// throws  Error as `knit_at_rest`, and if the springs are too stiff for the time step
///
/// Source: Sakaguchi and Miyata (2013), section 5 and figure 8.
KnitMotion knit_motion(const KnitNet& net, Places start, const KnitMotionOptions& options = {});

}  // namespace hada
