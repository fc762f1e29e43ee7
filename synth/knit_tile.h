#pragma once

#include "synth/knit_loops.h"

namespace hada {

/// The yarn that is seen at each pixel of a knit that tiles: the lattice is bent so that a whole
/// number of stitches and repeats fits each way.
KnitMaps tile_maps(const Knit<>& knit, const Extent& extent);

/// The share of each pixel of that tile that yarn covers: 0 in the middle of a hole. Edges are soft
/// on tiles of up to 16 million pixels.
Grid<float> tile_opacity(const Knit<>& knit, const Extent& extent);

}  // namespace hada
