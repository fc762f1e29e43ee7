#include "mechanics/knit_motion.h"

#include <algorithm>

#include "core/error.h"
#include "mechanics/knit_rest.h"

namespace hada {

KnitMotion knit_motion(const KnitNet& net, Places start, const KnitMotionOptions& options) {
  expect_whole(net, start);
  // Four springs act on a point against their neighbours' ends, and eq. 2 adds c to two of them.
  const double stiffest =
      *std::max_element(net.stiffness.begin(), net.stiffness.end()) * (8.0 + 4.0 * net.continuity);
  if (stiffest * options.time_step * options.time_step >= 4.0 - 2.0 * options.damping) {
    throw Error("springs of this stiffness need a shorter time step than the one given");
  }
  KnitMotion result{std::move(start), {}, false};
  Places speed(result.places.size(), Eigen::Vector3d::Zero());
  for (int step = 0; step < options.most_steps; ++step) {
    const Places force = forces(net, springs_of(net, result.places));
    double longest = 0.0;
    for (int i = 0; i < net.points(); ++i) {
      if (net.is_pinned(i)) continue;
      const auto p = std::size_t(i);
      speed[p] = (1.0 - options.damping) * (speed[p] + options.time_step * force[p]);
      result.places[p] += options.time_step * speed[p];
      longest = std::max(longest, options.time_step * speed[p].norm());
    }
    result.motion.push_back(longest / net.wale_length);
    result.settled = result.motion.back() < options.still;
    if (result.settled) break;
  }
  return result;
}

}  // namespace hada
