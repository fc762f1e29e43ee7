#pragma once

#include "core/grid.h"

namespace hada {

/// How many hills `height` has inside `mask`: summits from which one must go down by `least_rise`
/// or more before one can climb higher. The highest summit of a region counts always.
///
/// Source: ISO 25178-2, 3.3.8 (Wolf pruning); found by flooding from above with merging regions
/// (Edelsbrunner, Letscher and Zomorodian, Discrete and Computational Geometry 28, 2002).
int hill_count(const Grid<float>& height, const Mask& mask, double least_rise);

}  // namespace hada
