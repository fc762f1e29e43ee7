#pragma once

#include <cstddef>
#include <vector>

#include "core/grid.h"
#include "core/surface.h"

namespace hada {

/// How often a map takes each value.
struct Histogram {
  double low = 0.0;             // where the first bin begins, in the unit of the values
  double step = 1.0;            // width of a bin
  std::vector<double> density;  // share of the pixels per unit; what lies outside has its share too
  std::vector<double> sigma;    // standard error of `density`; NaN where the mask is one block

  double middle(std::size_t bin) const { return low + (double(bin) + 0.5) * step; }
};

/// The histogram of `values` inside `mask`, in `bins` equal bins from `low` to `high`.
///
/// Neighbours are alike, so the standard error is that of a jackknife over 4 x 4 blocks; it holds
/// where the values are alike over less than a block.
Histogram histogram(const Grid<float>& values, const Mask& mask, double low, double high,
                    int bins = 48);

/// The steepness of a height at every pixel, |gradient|, by central differences inside the mask.
Grid<float> steepness(const Grid<float>& height, const Mask& mask, double pitch);

}  // namespace hada
