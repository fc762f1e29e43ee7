#pragma once

#include "core/bounding_box.h"
#include "core/grid.h"

namespace hada {

/// Means over square blocks.
struct CoarseMap {
  PixelBox box;  // of the map that it covers
  int block = 1;
  Grid<double> height;  // about its mean; 0 outside the mask
  Mask mask;
  double pitch = 0.0;
  double variance = 0.0;
};

/// Some 128 steps over the longer side of the bounding box of `mask`, where the shorter one has at
/// least 16 then. A block counts that lies in the mask by half or more.
///
/// mask  not empty
CoarseMap coarse_map(const Grid<float>& map, const Mask& mask, double pitch);

}  // namespace hada
