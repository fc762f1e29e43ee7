#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/camera.h"
#include "core/sphere.h"

namespace hada {

/// Where a ray first meets a sphere, and the outward unit normal there.
template <class T>
struct Hit {
  Eigen::Matrix<T, 3, 1> point;
  Eigen::Matrix<T, 3, 1> normal;
};

/// T is double or a Jet; nothing where the ray passes by.
template <class T>
std::optional<Hit<T>> first_hit(const Ray& ray, const Eigen::Matrix<T, 3, 1>& center,
                                const T& radius) {
  using std::sqrt;
  const Eigen::Matrix<T, 3, 1> origin = ray.origin.cast<T>();
  const Eigen::Matrix<T, 3, 1> way = ray.direction.cast<T>();
  const Eigen::Matrix<T, 3, 1> to_center = center - origin;
  const T along = to_center.dot(way);
  const T reach = radius * radius - (to_center.squaredNorm() - along * along);
  if (!(reach > T(0.0))) return std::nullopt;
  const Eigen::Matrix<T, 3, 1> point = origin + (along - sqrt(reach)) * way;
  return Hit<T>{point, (point - center) / radius};
}

/// What a mirror ball shows along a ray: the ray goes on from `point` in the unit `direction`.
template <class T>
struct Mirrored {
  Eigen::Matrix<T, 3, 1> point;
  Eigen::Matrix<T, 3, 1> direction;
};

/// w - 2 (w.n) n for the way w of the ray; nothing where it passes by.
template <class T>
std::optional<Mirrored<T>> mirrored(const Ray& ray, const Eigen::Matrix<T, 3, 1>& center,
                                    const T& radius) {
  const auto hit = first_hit<T>(ray, center, radius);
  if (!hit) return std::nullopt;
  const Eigen::Matrix<T, 3, 1> way = ray.direction.cast<T>();
  return Mirrored<T>{hit->point, way - T(2.0) * way.dot(hit->normal) * hit->normal};
}

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
