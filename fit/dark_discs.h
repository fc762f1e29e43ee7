#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "core/grid.h"

namespace hada {

struct Disc {
  Eigen::Vector2d place;  // row, col
  double radius;          // px
  bool alone = false;     // a part of its own, and as round as a disc
};

/// Calls `visit(row, col)` for each pixel of `map` nearer to the middle than the radius and
/// `rim_px` more.
template <typename Map, typename Visit>
void for_pixels_in(const Disc& disc, double rim_px, const Map& map, const Visit& visit) {
  const double reach = disc.radius + rim_px;
  const int first_row = std::max(0, int(std::ceil(disc.place.x() - reach)));
  const int last_row = std::min(map.rows() - 1, int(std::floor(disc.place.x() + reach)));
  const int first_col = std::max(0, int(std::ceil(disc.place.y() - reach)));
  const int last_col = std::min(map.cols() - 1, int(std::floor(disc.place.y() + reach)));
  for (int row = first_row; row <= last_row; ++row) {
    for (int col = first_col; col <= last_col; ++col) {
      if ((Eigen::Vector2d(row, col) - disc.place).norm() < reach) visit(row, col);
    }
  }
}

/// The discs that the dark parts of a picture are made of, overlapping ones taken apart.
///
/// Each part is taken for the union of as few discs as cover it: the largest that fits in first,
/// then the largest in what is left; their circles are fitted to where its border runs between
/// pixels.
///
/// dark  0 outside discs, 1 inside, between where a pixel sees both; NaN where there is no picture
std::vector<Disc> dark_discs(const Grid<float>& dark);

}  // namespace hada
