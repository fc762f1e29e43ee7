#pragma once

#include <cstdint>

#include "reconstruct/tile.h"

namespace hada {

/// Where the answers of neighbouring pixels go.
struct NormalOutput {
  float* normals;      // x, y, z of one pixel after another
  float* rho;          // the albedo in grey
  std::uint8_t* mask;  // read as well: whether the pixel is to be solved
};

/// Splits tile.x, y, z (albedo times normal) of `count` pixels from `first` on into a unit normal
/// and the albedo, and takes pixels without an answer out of the mask.
///
/// A pixel has none where nothing was solved or n_z is below 0.02: beyond 88.9 degrees a slope
/// means nothing. Its albedo becomes 0; the normal of a pixel outside the mask becomes (0, 0, 1).
void put_unit_normals(const Tile& tile, int first, int count, const NormalOutput& output);

}  // namespace hada
