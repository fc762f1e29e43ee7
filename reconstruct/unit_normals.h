#pragma once

#include "reconstruct/tile.h"

namespace hada {

/// Splits tile.x, y, z (albedo times normal) into a unit normal, left there, and tile.rho.
///
/// rho becomes 0 where there is no answer or n_z is below 0.02: beyond 88.9 degrees a slope means
/// nothing.
void split_albedo(Tile& tile);

}  // namespace hada
