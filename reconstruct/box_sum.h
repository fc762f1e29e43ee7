#pragma once

#include <algorithm>

#include "core/grid.h"
#include "core/parallel.h"

namespace hada {

/// The sum of `values` over the square of 2 * radius + 1 pixels around each pixel, cut at the edge.
///
/// Every window is summed anew, so the result does not depend on how rows are shared out.
inline Grid<float> box_sum(const Grid<float>& values, int radius) {
  Grid<float> across(values.rows(), values.cols());
  for_each_index(values.rows(), [&](int row) {
    const auto in = values.row(row);
    const auto out = across.row(row);
    for (int col = 0; col < values.cols(); ++col) {
      const int last = std::min(col + radius, values.cols() - 1);
      for (int c = std::max(col - radius, 0); c <= last; ++c) out[col] += in[c];
    }
  });
  Grid<float> sums(values.rows(), values.cols());
  for_each_index(values.rows(), [&](int row) {
    const auto out = sums.row(row);
    const int last = std::min(row + radius, values.rows() - 1);
    for (int r = std::max(row - radius, 0); r <= last; ++r) {
      const auto in = across.row(r);
      for (int col = 0; col < values.cols(); ++col) out[col] += in[col];
    }
  });
  return sums;
}

}  // namespace hada
