#pragma once

#include <Eigen/Core>

#include "core/grid.h"

namespace hada {

/// A height map that casts shadows: its cells joined bilinearly, nothing around it.
class Relief {
 public:
  Relief() = default;
  /// height  >= 0, in the unit of `pitch`, the distance between neighbouring cells
  Relief(Grid<float> height, double pitch);

  const Grid<float>& height() const { return height_; }

  /// Whether the relief stands between a point and the light in the unit direction `to_light`.
  /// pixel  (row, col) of the point, fractions between cells
  /// z      its height, on the relief or above
  bool hides(const Eigen::Vector2d& pixel, double z, const Eigen::Vector3d& to_light) const;

 private:
  double height_at(double row, double col) const;

  Grid<float> height_;
  double pitch_ = 1.0;
  double top_ = 0.0;      // the largest height
  Grid<float> steepest_;  // of each block of cells and the blocks around it, height per cell
};

}  // namespace hada
