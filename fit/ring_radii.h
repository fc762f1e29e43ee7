#pragma once

#include <vector>

#include "fit/ring_edges.h"
#include "fit/unrolled.h"

namespace hada {

/// Effective radii where all sectors together see a ring end, rising.
std::vector<double> ring_radii(const Unrolled& flat, double pitch);

/// The edges next to each radius, ring by ring, moved to the middle of their rise.
///
/// reach  how far an edge may lie from its radius; never more than 0.4 of the way to the next ring
std::vector<RingChain> edges_of_rings(const std::vector<double>& radii,
                                      const std::vector<std::vector<RingEdge>>& edges,
                                      const Unrolled& flat, double reach, double pitch);

/// Rings that wander too far in and out to show where all sectors are looked at together: between
/// two neighbours of `rings`, pieces that lie more than `reach` away from both and that together go
/// half the way around or further.
///
/// rings   of all sectors, rising; none is empty
/// chains  pieces of rings of the same sectors
std::vector<RingChain> wandering_rings(const std::vector<RingChain>& rings,
                                       const std::vector<RingChain>& chains, const Unrolled& flat,
                                       double reach, double pitch);

/// Whether the picture gets lighter outward where a ring should be by what it is beside: noise has
/// steep places in any sector, but not where those of other sectors say. True of a ring that
/// fewer than 24 sectors see: so few may be too far from each other to tell.
bool stands_out(const RingChain& ring, const Unrolled& flat, double pitch);

/// The middle radius of a ring's edges.
double radius_of(const RingChain& ring);

/// How many sectors of `flat` see the wood at this effective radius.
int sectors_at(const Unrolled& flat, double rho);

}  // namespace hada
