#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/extent.h"
#include "core/grid.h"
#include "synth/growth.h"

namespace hada {

/// Where the rings of a stem lie around each other.
struct GrowthFrame {
  Eigen::Vector2d pith{0.0, 0.0};  // in the unit of the extent
  std::vector<GrowthLobe<>> lobes;

  double rho_of(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d arm = place - pith;
    return effective_radius(lobes, arm.norm(), std::atan2(arm.y(), arm.x()));
  }
  Eigen::Vector2d place_of(double rho, double theta) const {
    return pith + GrowthRay(lobes, theta).radius_at(rho) *
                      Eigen::Vector2d(std::cos(theta), std::sin(theta));
  }
};

/// A picture of an end grain laid flat: a row for each sector around the pith, a column for each
/// effective radius; straight columns are what the frame expects rings to be.
struct Unrolled {
  Grid<float> values;         // median over the rays of the sector, NaN where fewer than 3 see wood
  std::vector<double> theta;  // middle of each sector, counter-clockwise from +x
  double first = 0.0;         // effective radius of column 0, in the unit of the extent
  double step = 0.5;          // from column to column
  double sector_rad = 0.0;    // width of a sector
  bool whole_turn = false;    // the last sector is a neighbour of the first
  double joined = 0.0;        // arc that a sector sees at least, in the unit of the extent

  double rho(double col) const { return first + col * step; }

  /// How many sectors on each side a sector at this effective radius was averaged with.
  int joined_at(double rho) const;
};

struct UnrollOptions {
  double step_px = 0.5;     // along the radius
  double sector_px = 40.0;  // width of a sector at the rim
  double ray_px = 1.7;      // distance between rays at the rim
};

/// `map` at `pixel` (row, col), bilinear; NaN where a neighbour is outside the mask.
float value_at(const Grid<float>& map, const Mask& mask, const Eigen::Vector2d& pixel);

/// The sectors that see the picture; the median over rays takes away pores and wood rays. Near the
/// pith, where sectors are narrow, neighbours are averaged until they see 16 px.
///
/// throws  Error if the frame sees no picture
Unrolled unrolled(const Grid<float>& map, const Mask& mask, const Extent& extent,
                  const GrowthFrame& frame, const UnrollOptions& options = {});

}  // namespace hada
