#pragma once

#include <string>

#include "core/surface.h"

namespace hada {

/// A surface as a page draws it, little-endian: 10 words of 32 bits (the letters "HADA", columns,
/// rows, flags: 1 normals, 2 albedo, 4 height, 8 unit mm, 16 sigma of normals, 32 sigma of height;
/// floats: pitch, lowest and highest height, and of albedo and both sigmas what one pixel in 200
/// exceeds), then what the flags name: normals and mask, four halves for each pixel; albedo, red,
/// green, blue and 1, four halves; height, sigma of the normals in radians, sigma of the height, a
/// float each. A row of pixels follows the other from the top.
std::string surface_bytes(const Surface& surface);

}  // namespace hada
