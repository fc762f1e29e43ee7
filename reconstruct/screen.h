#pragma once

#include <cstdint>
#include <vector>

#include "reconstruct/tile.h"

namespace hada {

/// 1 where least squares leaves a pixel a residual that its noise does not explain (over three
/// sigma), where a sample may not count, or where the normal looks away from a light; else 0.
///
/// found  tile.x, y, z, by least squares
void screen(const Tile& tile, std::vector<std::uint8_t>& doubtful);

/// Fewest lights for `drop_worst`: whichever sample of six is dropped, four are in both fits, so
/// that two answers which explain all others cannot lie far apart.
inline constexpr int lights_for_dropping = 6;

/// Least squares without the sample that disagrees most, for tiles of distant lights in which every
/// sample counts; weights as that says. Most doubtful pixels have one bad sample.
///
/// With p_k the column of the pseudo-inverse and h_k = l_k.p_k, dropping sample k turns the answer
/// by -p_k r_k / (1 - h_k) and the squared residuals fall by r_k^2 / (1 - h_k): the sample where
/// they fall most goes (R. D. Cook and S. Weisberg, Residuals and influence in regression, 1982).
///
/// found     tile.x, y, z, by least squares over all samples
/// doubtful  1 where the others still do not agree, as `screen` says; else 0
void drop_worst(Tile& tile, const std::vector<float>& pseudo_inverse,
                std::vector<std::uint8_t>& doubtful);

}  // namespace hada
