#pragma once

#include <vector>

#include "fit/block.h"

namespace hada {

/// Which way fibres go up, dx/dz and dy/dz: that of all faces along the stem together. A block that
/// was cut askew of its stem has rings that lean with its fibres.
Eigen::Vector2d fibre_lean(const std::vector<PlacedFace>& faces);

/// Writes into `wood` how fibres turn around the stem, from the face that shows most of it where it
/// is tangential; a remark if none does.
void add_turning(Fit<Wood<>>& wood, const GrowthSolid& solid, const std::vector<PlacedFace>& faces);

}  // namespace hada
