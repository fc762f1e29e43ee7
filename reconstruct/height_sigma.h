#pragma once

#include "core/grid.h"
#include "core/surface.h"

namespace hada {

/// The standard deviation of the height that `integrate` finds, from that of the normals.
///
/// Independent errors of the normals are drawn, integrated and levelled as the height is, and the
/// spread at each pixel (smoothed over its neighbourhood) is returned.
///
/// normal_sigma  radians along each tangent axis
/// returns       in the unit of `pitch`; 0 outside the mask
Grid<float> height_sigma(const NormalMap& normals, const Grid<float>& normal_sigma,
                         const Mask& mask, double pitch, bool plane_removed);

}  // namespace hada
