#pragma once

#include <optional>

#include "core/grid.h"

namespace hada {

/// A map, and where it has a meaning.
struct MaskedMap {
  Grid<float> map;
  Mask mask;
};

/// Holes of up to so many pixels are filled where waves are asked for: what a film across one lacks
/// of them is little, where a taper that falls off towards each would leave nothing of a map with
/// holes all over.
inline constexpr int largest_small_hole = 400;

/// The map with its small holes filled: patches of pixels outside the mask that touch along edges,
/// at most `most_pixels` each, and none at a side of the map. Every pixel of a hole becomes the
/// mean of its four neighbours, as a film of soap would lie. Empty where there is no such hole.
///
/// map, mask  of one size; what the map holds outside the mask is not read
std::optional<MaskedMap> without_small_holes(const Grid<float>& map, const Mask& mask,
                                             int most_pixels = largest_small_hole);

}  // namespace hada
