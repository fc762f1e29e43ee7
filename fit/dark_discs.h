#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/grid.h"

namespace hada {

struct Disc {
  Eigen::Vector2d place;  // row, col
  double radius;          // px
  bool alone = false;     // a part of its own, and as round as a disc
};

/// The discs that the dark parts of a picture are made of, overlapping ones taken apart.
///
/// Each part is taken for the union of as few discs as cover it: the largest that fits in first,
/// then the largest in what is left; their circles are fitted to where its border runs between
/// pixels.
///
/// dark  0 outside discs, 1 inside, between where a pixel sees both; NaN where there is no picture
std::vector<Disc> dark_discs(const Grid<float>& dark);

}  // namespace hada
