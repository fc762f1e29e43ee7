#pragma once

#include "core/grid.h"

namespace hada {

/// How brightness changes from pixel to pixel, along u (right) and v (down).
struct Gradient {
  Grid<float> u, v;
};

/// Of the brightness over that of bright things (its 95th percentile), smoothed over about a pixel;
/// 0 along the frame.
Gradient gradient_of(const Grid<float>& grey);

}  // namespace hada
