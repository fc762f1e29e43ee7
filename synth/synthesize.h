#pragma once

#include <array>

#include "core/extent.h"
#include "core/random.h"
#include "core/surface.h"
#include "synth/material.h"

namespace hada {

/// More of the surface that `material` describes.
///
/// extent   size and pitch; the surface tiles without a seam at its borders. For a spectral
///          material the seed, the width and the height in mm decide the field, the pitch only how
///          finely it is sampled: a finer pitch adds detail and keeps what was there.
/// returns  height, normals and a full mask; zero-mean height; the albedo of a spectral material is
///          one plane of 0.8
/// throws   Error if the extent is empty or its pitch is not a positive number
Surface synthesize(const Material& material, const Extent& extent, Seed seed);

/// A window of a surface without end: what lies at a place depends on material, seed and place.
///
/// middle   of the window on the whole, in the unit of the extent: x right, y up; windows a whole
///          number of pixels apart agree where they overlap
/// returns  height, normals, albedo and a full mask; it does not tile, and keeps its mean height
/// throws   Error as `synthesize`, and if the material is not one that has places: wrinkles have,
///          and a stem of wood in the plane of its cut
Surface synthesize_window(const Material& material, const Extent& window,
                          const std::array<double, 2>& middle, Seed seed);

}  // namespace hada
