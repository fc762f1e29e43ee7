#pragma once

#include <string_view>

#include <Eigen/Core>

namespace hada {

/// What a length is counted in: millimetres, or pixels where nobody knows the pitch.
enum class Unit { mm, px };

inline std::string_view name_of(Unit unit) {
  return unit == Unit::mm ? "mm" : "px";
}

/// The lattice of pixel centres of a sample: how many, how far apart, and where they lie.
///
/// Frame: right-handed, x right, y up, z towards the camera, origin at the centre of the grid. This
/// struct is the only place that knows that rows run downward.
struct Extent {
  int rows = 0;
  int cols = 0;
  double pitch = 1.0;  // distance between neighbouring pixels, in `unit`, > 0
  Unit unit = Unit::px;

  /// The centre of pixel (row, col), in `unit`. Fractions are places between centres.
  Eigen::Vector2d place(double row, double col) const {
    return {(col + 0.5 - 0.5 * cols) * pitch, (0.5 * rows - row - 0.5) * pitch};
  }
  /// The (row, col) whose centre is `place`: the inverse of `place`.
  Eigen::Vector2d pixel(const Eigen::Vector2d& place) const {
    return {0.5 * rows - 0.5 - place.y() / pitch, place.x() / pitch + 0.5 * cols - 0.5};
  }
  double width() const { return cols * pitch; }
  double height() const { return rows * pitch; }

  bool operator==(const Extent&) const = default;
};

}  // namespace hada
