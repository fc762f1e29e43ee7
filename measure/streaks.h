#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/extent.h"
#include "core/grid.h"

namespace hada {

/// How the fine streaks of a part of a picture lean.
struct Streak {
  Eigen::Vector2d place;  // middle of the part, in the unit of the extent
  double slope;           // to the right for each step up
  double likeness;        // correlation along the streaks, 0 to 1
};

struct StreakOptions {
  int tile_rows = 32;  // of a part, px
  int tile_cols = 80;
  double steepest = 0.7;         // slope that is looked for, to either side
  double least_likeness = 0.08;  // of a part that is kept
};

/// Streaks that run up the picture, part by part, by how rows are alike that lie a few steps apart.
///
/// Only what is finer than some three px counts, and not beside stronger lines such as the borders
/// of rings, which run their own way.
std::vector<Streak> streaks(const Grid<float>& map, const Mask& mask, const Extent& extent,
                            const StreakOptions& options = {});

}  // namespace hada
