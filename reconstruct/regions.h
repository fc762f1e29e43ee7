#pragma once

#include <vector>

#include "core/grid.h"

namespace hada {

/// The connected regions of a mask: pixels that touch along an edge belong together.
struct Regions {
  Grid<int> label;        // of a pixel; 0 outside the mask
  std::vector<int> size;  // in pixels, by label; size[0] is what lies outside
};

Regions regions_of(const Mask& mask);

}  // namespace hada
