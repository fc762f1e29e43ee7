#pragma once

#include "reconstruct/pixel_level.h"

namespace hada {

/// The next coarser level: cells joined 2 x 2, a block that falls into parts gives one node for
/// each.
///
/// An edge between two blocks stands for two halves of a block and the edges that cross in between,
/// in series: 1 / (1 / crossing + reach + reach), reach = 1 / (2 inside) and inside the edges that
/// join the halves. In an even lattice that is half of what crosses. Over a bridge one pixel wide
/// it falls as slowly as the conductance of a constriction does.
///
/// least_strength  a part hangs together by edges that are at least this share of all edges at both
///                 of their ends; in an even lattice each has 0.25
/// `fine` learns which of its cells moved to an extra node.
/// Source: the series rule after R. E. Alcouffe et al., SIAM J. Sci. Stat. Comput. 2 (1981).
PixelLevel coarsened(PixelLevel& fine, float least_strength);

}  // namespace hada
