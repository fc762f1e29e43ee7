#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "core/extent.h"
#include "fit/growth_solid.h"

namespace hada {

/// A place on the line that the end of a ring draws on a cut.
struct RingStation {
  std::size_t ring = 0;
  int run = 0;             // stations of one run follow each other along the line
  Eigen::Vector2d place;   // in the picture of the cut
  Eigen::Vector2d normal;  // unit vector within the picture, towards larger rho
  double slope = 0.0;      // of rho along that
  double sigma = 0.0;      // standard deviation of rho - radius
};

/// The lines of all rings of `solid` on a picture of a cut, a station every `step_px`.
///
/// Left out is where the cut runs along the rings (`least_slope` of rho within the picture): a line
/// that may lie anywhere is none.
std::vector<RingStation> ring_lines(const GrowthSolid& solid, const Cut& cut, const Extent& extent,
                                    int step_px = 4, double least_slope = 0.06);

}  // namespace hada
