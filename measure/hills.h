#pragma once

#include <cstddef>
#include <functional>

#include "core/grid.h"

namespace hada {

struct HillOptions {
  /// Above the pass to a higher hill, below which the summit at this pixel is none.
  std::function<double(std::size_t pixel)> least_rise = [](std::size_t) { return 0.0; };
  bool columns_wrap = false;  // the first column follows on the last, as angles do
};

/// A map divided among its hills.
struct Hills {
  Grid<int> of_pixel;  // number of the hill, the highest first; -1 outside the mask
  int count = 0;
};

/// The hills of `height` inside `mask`: summits from which one must go down by `least_rise` or more
/// before one can climb higher, each with the ground that falls off from it. The highest summit of
/// a region counts always.
///
/// Source: ISO 25178-2, 3.3.8 (Wolf pruning); found by flooding from above with merging regions.
Hills hills(const Grid<float>& height, const Mask& mask, const HillOptions& options);

}  // namespace hada
