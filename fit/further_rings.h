#pragma once

#include <vector>

#include "fit/ring_sightings.h"

namespace hada {

/// Effective radii of rings that faces show and `solid` does not list: beyond those of the end
/// grain, or between two of them that have room for one more.
///
/// All faces are gathered by effective radius where that is known well enough; a dark line there
/// that is about as strong as those of the rings already known is one more ring.
std::vector<double> further_rings(const std::vector<BlockFace>& faces, const GrowthSolid& solid);

}  // namespace hada
