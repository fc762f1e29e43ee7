#pragma once

#include <algorithm>
#include <cmath>

#include "measure/spectrum.h"

namespace hada {

/// Calls visit(row, col, fx, fy, times) for every ordinate of half the plane but frequency 0 where
/// |fx| <= most_fx and |fy| <= most_fy, in the order of rows; `times` that it stands for in a sum
/// over the whole plane: f and -f are two.
template <class Visit>
void visit_half_plane(const Spectrum& spectrum, double most_fx, double most_fy,
                      const Visit& visit) {
  const int cols = spectrum.extent.cols;
  const int last = int(std::min(std::floor(most_fx * spectrum.extent.width()), 0.5 * cols));
  for (int row = 0; row < spectrum.extent.rows; ++row) {
    const double fy = spectrum.fy(row);
    if (std::abs(fy) > most_fy) continue;
    for (int col = row == 0 ? 1 : 0; col <= last; ++col)
      visit(row, col, spectrum.fx(col), fy, col == 0 || 2 * col == cols ? 1 : 2);
  }
}

}  // namespace hada
