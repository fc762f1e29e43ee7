#pragma once

#include "core/random.h"
#include "core/surface.h"

namespace hada {

/// Every second pixel of a field that was made finer, from (first, first) on, with white noise:
/// what is fitted is never on the lattice of what was made.
inline Surface finer_sample(const Grid<float>& field, int first, const Extent& extent,
                            double noise_mm, Seed seed) {
  Surface sample;
  sample.extent = extent;
  sample.mask = full_mask(extent);
  sample.height = Grid<float>(extent.rows, extent.cols);
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      sample.height(row, col) =
          field(first + 2 * row, first + 2 * col) + float(noise_mm * gaussian(seed, row, col));
    }
  }
  return sample;
}

}  // namespace hada
