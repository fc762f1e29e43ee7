#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/camera.h"
#include "core/sphere.h"

namespace hada {

/// A sphere in space, in the frame and unit of the camera.
struct SphereInSpace {
  Eigen::Vector3d center{0.0, 0.0, 0.0};
  double radius = 1.0;

  /// The outward unit normal where the ray through (u, v) first meets the sphere.
  std::optional<Eigen::Vector3d> normal_at(const Camera& camera, double u, double v) const;
};

/// Where the outline of a sphere is seen: its centre (u, v) and the radius of the circle of its
/// area, in px. Orthographic: a circle. Perspective: the ellipse in which its tangent cone about
/// the eye cuts the picture plane, a = f sin b cos b / k, area^(1/2) radius (a a')^(1/2), k = cos^2
/// a - sin^2 b, with a the angle off the axis and b the half-angle of the cone.
Sphere outline(const SphereInSpace& sphere, const Camera& camera);

/// The sphere that rests on the plane z = 0 and has this outline: the inverse of `outline`.
SphereInSpace in_space(const Sphere& outline, const Camera& camera);

}  // namespace hada
