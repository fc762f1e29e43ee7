#pragma once

#include "core/grid.h"

namespace hada {

/// Of the variance of a height: beyond, it is a map that nobody has levelled, and numbers tell of
/// its tilt.
constexpr double much_plane = 2.0 / 3.0;

/// How much of the variance of a height inside `mask` is a plane: 0 to 1; 0 of a flat map.
double plane_share(const Grid<float>& height, const Mask& mask);

}  // namespace hada
