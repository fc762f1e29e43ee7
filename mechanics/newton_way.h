#pragma once

#include "mechanics/gmres.h"
#include "mechanics/knit_frames.h"

namespace hada {

/// The way, in the frames, along which the forces of a net change by `load`: points that go back
/// along it are rid of it, to first order.
///
/// drag   added to the stiffness of every point
/// solve  about the inverse of that stiffness, its symmetric part factorised
template <class Net, class Springs, class Solve>
GmresSolution newton_way(const Net& net, const Springs& springs, const KnitFrames& frames,
                         const Places& load, double tolerance, double drag, const Solve& solve) {
  const auto apply = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    const Places way = in_space(frames, net.pinned, x);
    Places change = force_changes(net, springs, way);
    for (std::size_t i = 0; i < frames.turning.size(); ++i) change[i] += frames.turning[i] * way[i];
    return within(frames, net.pinned, change) - drag * x;
  };
  return gmres(
      apply, [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return -solve(x); },
      within(frames, net.pinned, load), tolerance);
}

}  // namespace hada
