#pragma once

#include <cmath>
#include <vector>

#include "core/random.h"
#include "fit/ring_sightings.h"

namespace hada {

/// A face of a stem whose rings each begin with a dark line, 6 px wide, with noise.
inline BlockFace dark_lines(const GrowthSolid& solid, const std::vector<double>& radii,
                            const Cut& cut, const Extent& extent) {
  BlockFace face{Grid<float>(extent.rows, extent.cols), full_mask(extent), extent, cut};
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      const Eigen::Vector2d place = extent.place(row, col);
      const double rho = local_of(solid, cut.at(place.x(), place.y()), false).rho;
      double value = 0.02 * gaussian(9, row, col);
      for (const double radius : radii) {
        const double t = (rho - radius) / (2.5 * extent.pitch);
        value -= 0.3 * std::exp(-0.5 * t * t);
      }
      face.absorbance(row, col) = float(value);
    }
  }
  return face;
}

/// Rings that hardly bend: the pith lies far off, and leans.
inline GrowthSolid far_stem() {
  GrowthSolid solid;
  solid.frame.pith = {-60.0, -400.0};
  solid.lean = {0.02, -0.15};
  for (int k = 0; k < 8; ++k) solid.radii.push_back(330.0 + 22.0 * k);
  return solid;
}

}  // namespace hada
