#pragma once

#include <string>

#include "core/surface.h"

namespace hada {

/// A surface as a page draws it, little-endian: 8 words of 32 bits (the letters "HADA", columns,
/// rows, flags: 1 normals, 2 albedo, 4 height, 8 unit mm; floats: pitch, lowest and highest height,
/// the albedo that only one pixel in 200 is lighter than), then what the flags name: normals and
/// mask, four halves for each pixel; albedo, red, green, blue and 1, four halves; height, a float.
/// A row of pixels follows the other from the top.
std::string surface_bytes(const Surface& surface);

}  // namespace hada
