#pragma once

#include <vector>

#include "reconstruct/pixel_level.h"

namespace hada {

/// Gives every part of the blocks that fall apart a node of its own in `coarse`.
///
/// split_cols  for every row of blocks, the columns of those whose cells do not hang together
/// least       share of all edges at one of its ends, below which an edge does not hold a part
/// coarse      holds sums of edges so far: inside a block in `reach_*`, crossing in `east`, `south`
///
/// The largest part stays the cell of the lattice, whose sums become its own alone. Blocks that
/// hold extra nodes of `fine` are treated here too.
void split_blocks(PixelLevel& fine, std::vector<std::vector<int>> split_cols, float least,
                  PixelLevel& coarse);

}  // namespace hada
