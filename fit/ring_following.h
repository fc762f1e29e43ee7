#pragma once

#include <vector>

#include "fit/ring_sightings.h"
#include "fit/solid_fit.h"

namespace hada {

struct Followed {
  GrowthSolid solid;
  std::vector<FaceScatter> faces;
};

/// Rings followed from where they are known over all faces: predict, look, learn, until nothing new
/// is seen.
///
/// Where rings are seen by their pores (`RingMark::line`), pieces of lines that belong to any ring
/// say how rings bend before they can be told from each other, and rings that `start` does not
/// list are taken up from the nearest on. Ripples, where rings wander, are as high as faces that
/// are left out in turn ask for.
///
/// start    what the end grain says
/// scatter  by how much rings lie beside it there
/// throws   Error if too few rings can be followed
Followed followed_rings(const std::vector<BlockFace>& faces, const GrowthSolid& start,
                        const SolidPrior& prior, RingMark mark, double scatter);

}  // namespace hada
