#pragma once

#include "core/grid.h"

namespace hada {

/// How many hills `height` has inside `mask`: summits from which one must go down by more than
/// `least_rise` before one can climb higher. The highest of a region counts always.
///
/// Source: ISO 25178-2, 3.3.8 (Wolf pruning); found by flooding from above with merging regions.
int hill_count(const Grid<float>& height, const Mask& mask, double least_rise);

}  // namespace hada
