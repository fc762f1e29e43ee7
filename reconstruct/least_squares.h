#pragma once

#include <vector>

#include "reconstruct/tile.h"

namespace hada {

/// Least squares over the samples that may count: rho n = (sum l l^T)^-1 sum l I.
///
/// Source: R. J. Woodham, Optical Engineering 19 (1980).
void fit_least_squares(Tile& tile);

/// The same where every sample counts and the lights are distant, so that one matrix serves all.
///
/// pseudo_inverse  of the directions: three rows of `tile.lights` values
void fit_pseudo_inverse(Tile& tile, const std::vector<float>& pseudo_inverse);

/// The same bytes straight from the pictures, for those who need no more of the samples than this.
///
/// count  pixels, at least `lane_count`
/// tile   of which nothing but x, y, z is touched
void fit_pseudo_inverse(const GreyRows& rows, int count, const std::vector<float>& pseudo_inverse,
                        Tile& tile);

}  // namespace hada
