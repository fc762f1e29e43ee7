#pragma once

#include <vector>

#include "core/surface.h"
#include "fit/ring_lines.h"
#include "fit/solid_fit.h"

namespace hada {

/// What is looked for where a ring ends.
enum class RingMark {
  edge,  // dark latewood, then light earlywood outward
  line,  // the dark line of the pores that a ring of a ring-porous wood begins with
};

/// A picture of a stem, ready to be looked at.
struct BlockFace {
  Grid<float> absorbance;  // logarithm of the brightness
  Mask wood;
  Extent extent;
  Cut cut;
};

/// The rings that `face` shows where `solid` expects them.
///
/// At every station of a ring that the solid is sure enough of to know it from its neighbours, the
/// picture is looked at across the line, the median along it; what is found next to where it is
/// expected is a sighting.
///
/// noise  by how much a line may lie beside its ring for other reasons, in the unit of the picture
std::vector<RingSighting> ring_sightings(const BlockFace& face, std::size_t index,
                                         const GrowthSolid& solid, RingMark mark, double noise);

}  // namespace hada
