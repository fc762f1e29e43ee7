#pragma once

#include "core/grid.h"

namespace hada {

/// How far heights of a map are alike (ISO 25178-2, Sal and Str).
struct TextureLengths {
  double shortest_px = 0.0;  // lag at which the autocorrelation falls to 0.2, in any direction
  double aspect = 0.0;       // that over the longest such lag, 0 to 1
};

/// height  not constant inside `mask`
TextureLengths texture_lengths(const Grid<float>& height, const Mask& mask);

/// Standard errors of `found`, by leaving out one of 4 x 4 blocks at a time. They rest on the map
/// binned to what its correlation needs, and of a very large one on its middle.
TextureLengths texture_lengths_sigma(const TextureLengths& found, const Grid<float>& height,
                                     const Mask& mask);

}  // namespace hada
