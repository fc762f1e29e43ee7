#pragma once

#include <vector>

namespace hada {

/// A place on a radius where dark latewood ends and the light earlywood of the next year begins.
struct RingBoundary {
  double index;  // where it rises most steeply, in samples, between them if need be
  double rise;   // of the brightness from the darkest place before to the lightest after
  double slope;  // the steepest, per sample
};

struct RingProfileOptions {
  double least_rise = 0.35;   // of the rises nearby, to be a ring and not a wavering within one
  double least_slope = 0.35;  // of the slopes nearby
  double noise = 0.0;         // rises below are none
  int neighbours = 6;         // rises on each side that "nearby" means
};

/// The boundaries along a profile of brightness from pith to bark.
///
/// brightness  any scale; finite
/// returns     in rising order; a dark maximum that no lighter place follows is no boundary
std::vector<RingBoundary> ring_boundaries(const std::vector<double>& brightness,
                                          const RingProfileOptions& options = {});

}  // namespace hada
