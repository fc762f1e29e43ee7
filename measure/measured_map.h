#pragma once

#include "core/surface.h"

namespace hada {

/// What there is to measure: the height of the surface or, where it has none, the brightness of its
/// albedo.
///
/// returns  the height in extent.unit; or the sRGB code of the luminance, 0 to 1: equal steps of it
///          look alike, and textures are nearer to Gaussian in it than in linear light
Grid<float> measured_map(const Surface& surface);

}  // namespace hada
