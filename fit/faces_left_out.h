#pragma once

#include <vector>

#include "fit/solid_fit.h"

namespace hada {

/// How many times further than expected the rings of a face lie that nobody has seen: every face is
/// left out in turn, and predicted from the others.
///
/// Such that bands widened by it hold nine tenths of the sightings, every face counting alike; and
/// wider by as much as Student's t of so few faces is than a Gaussian. Between 0.5 and 5; 1 if
/// fewer than two faces can be left out.
///
/// sightings, threads, start, prior, noise  as for `fitted_solid`
/// faces    what that said of each face
double surprise_of_faces(const std::vector<RingSighting>& sightings,
                         const std::vector<RingThread>& threads, const GrowthSolid& start,
                         const SolidPrior& prior, const std::vector<FaceScatter>& faces,
                         double noise);

}  // namespace hada
