#pragma once

#include <cstddef>
#include <vector>

#include "fit/ring_sightings.h"
#include "fit/solid_fit.h"

namespace hada {

/// Short pieces of the lines that rings draw on a face, whichever rings these are.
///
/// The structure tensor is followed both ways from the middles of a lattice, as long as it knows a
/// direction. No ring has to be told from its neighbours for that, so that a solid knows how rings
/// bend before it knows which is which.
///
/// ring_px  distance of rings on an end grain, px
std::vector<RingThread> ring_threads(const BlockFace& face, std::size_t index, double ring_px);

}  // namespace hada
