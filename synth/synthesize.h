#pragma once

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

}  // namespace hada
