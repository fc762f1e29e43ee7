#pragma once

#include <string>
#include <vector>

#include "core/surface.h"
#include "fit/fit.h"
#include "fit/growth_solid.h"
#include "fit/ring_sightings.h"
#include "fit/solid_fit.h"
#include "synth/wood.h"

namespace hada {

/// A picture of one side of a block, or of a cut through it, and where that lies.
struct PlacedFace {
  std::string name;
  Surface surface;
  Cut cut;
};

/// The face as rings are looked for on it; a plain background is left out.
BlockFace block_face(const PlacedFace& face);

struct BlockFit {
  Fit<Wood<>> wood;                // what a material can say of it
  GrowthSolid solid;               // all that is known of its rings
  RingMark mark = RingMark::edge;  // what its rings are seen by
  std::vector<FaceScatter> faces;  // in the order they were given
};

/// The one stem that all faces are cut from.
///
/// The rings of an end grain are found first, as `fit_wood` finds them. Where a solid that is known
/// from these expects rings on the other faces, with so little doubt that no ring can be taken for
/// its neighbour, they are looked for; what is found makes the solid surer, so that more can be
/// looked at, until nothing new is seen. Rings that wander as no pith and lobes can explain get
/// ripples, a Gaussian process in space, as rough and as high as the evidence wants them.
///
/// faces   in one unit; one at least is an end grain, cut across the stem (z)
/// throws  Error if there is none, or what `fit_wood` throws of it
BlockFit fit_block(const std::vector<PlacedFace>& faces);

}  // namespace hada
