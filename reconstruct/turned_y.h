#pragma once

#include "core/grid.h"
#include "core/surface.h"

namespace hada {

/// How much better the slopes of `normals` would agree with a height if their y pointed the other
/// way: the median square of what they add up to round squares of 1, 4 or 16 steps, over the same
/// with -y, from the squares that tell most. Round larger ones noise counts less.
///
/// A height has no curl, but with a y turned about one of 2 z_xy is left: well above 1, somebody
/// has the wrong convention in mind. About 1 where noise, or a surface that waves along x and y
/// apart, hides it.
///
/// normals  pixels outside `mask` are not read; of a large map every few rows are looked at
double gain_of_turned_y(const NormalMap& normals, const Mask& mask);

}  // namespace hada
