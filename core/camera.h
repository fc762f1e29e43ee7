#pragma once

#include <Eigen/Core>

#include "core/extent.h"

namespace hada {

/// A half-line, in the frame of the picture: where the light that met a pixel came from.
struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;  // unit, away from the camera
};

/// A camera straight above the table, its optical axis along -z through the middle of the picture.
///
/// Frame: that of the picture's `Extent`, with z = 0 the plane in which one pixel spans `pitch`.
/// Perspective puts the pin-hole at (0, 0, distance), distance = focal_px * pitch.
struct Camera {
  enum class Model { orthographic, perspective };

  Extent extent;
  Model model = Model::orthographic;
  double focal_px = 0.0;  // perspective only, > 0

  double distance() const { return focal_px * extent.pitch; }

  /// The ray through image point (u, v): u right, v down, the centre of the first pixel (0.5, 0.5).
  Ray ray(double u, double v) const {
    const Eigen::Vector2d place = extent.place(v - 0.5, u - 0.5);
    const Eigen::Vector3d on_table(place.x(), place.y(), 0.0);
    if (model == Model::orthographic) return {on_table, -Eigen::Vector3d::UnitZ()};
    const Eigen::Vector3d eye(0.0, 0.0, distance());
    return {eye, (on_table - eye).normalized()};
  }

  /// Where a point is seen: (u, v), the inverse of `ray`.
  Eigen::Vector2d project(const Eigen::Vector3d& point) const {
    const double scale = model == Model::orthographic ? 1.0 : distance() / (distance() - point.z());
    const Eigen::Vector2d pixel = extent.pixel(scale * point.head<2>());
    return {pixel.y() + 0.5, pixel.x() + 0.5};
  }
};

}  // namespace hada
