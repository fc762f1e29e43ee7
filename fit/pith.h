#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/extent.h"
#include "measure/line_field.h"

namespace hada {

/// A place where rings run across `normal`.
struct RingDirection {
  Eigen::Vector2d place;   // in the unit of the extent
  Eigen::Vector2d normal;  // unit length, towards the pith or away from it
  double weight;           // 0 to 1
};

/// Some thousand places spread over the picture, those without a direction left out.
std::vector<RingDirection> ring_directions(const LineField& field, const Extent& extent);

struct PithGuess {
  Eigen::Vector2d place;     // in the unit of the extent, inside the picture or outside
  double spread_rad = 0.0;   // typical angle by which rings run past it
  double oval_cosine = 0.0;  // of the lobe of order 2, see GrowthLobe
  double oval_sine = 0.0;
};

constexpr std::size_t fewest_directions = 50;

/// Where the normals of the rings meet, by several starts and a robust loss; then, if that lies
/// inside the picture, from ever smaller surroundings of it, because rings near the pith are round.
///
/// throws  Error if fewer than `fewest_directions` are given
PithGuess pith_guess(const std::vector<RingDirection>& directions, const Extent& extent);

}  // namespace hada
