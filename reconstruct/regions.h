#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/grid.h"

namespace hada {

/// The connected regions of a mask: pixels that touch along an edge belong together.
struct Regions {
  struct Run {
    int first;  // column
    int last;   // one beyond
    int region;
  };
  std::vector<Run> runs;            // of pixels side by side, row by row
  std::vector<std::size_t> starts;  // of every row in `runs`, and their end
  std::vector<int> size;            // of a region in pixels; size[0] is what lies outside

  std::span<const Run> row(int row) const {
    return {runs.data() + starts[std::size_t(row)], runs.data() + starts[std::size_t(row) + 1]};
  }
  /// The region of a pixel, 0 outside the mask. Regions are numbered from 1, as rows meet them.
  int label(int row, int col) const;
};

Regions regions_of(const Mask& mask);

}  // namespace hada
