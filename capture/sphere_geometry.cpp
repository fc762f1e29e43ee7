#include "capture/sphere_geometry.h"

#include <cmath>

namespace hada {

std::optional<Eigen::Vector3d> SphereInSpace::normal_at(const Camera& camera, double u,
                                                        double v) const {
  const auto hit = first_hit<double>(camera.ray(u, v), center, radius);
  if (!hit) return std::nullopt;
  return hit->normal;
}

Sphere outline(const SphereInSpace& sphere, const Camera& camera) {
  Sphere seen;
  if (camera.model == Camera::Model::orthographic) {
    seen.center_px = camera.project(sphere.center);
    seen.radius_px = sphere.radius / camera.extent.pitch;
    return seen;
  }
  const double depth = camera.distance() - sphere.center.z();
  const double off_axis = sphere.center.head<2>().norm();
  const double range = std::hypot(depth, off_axis);
  const double cos_a = depth / range;
  const double sin_a = off_axis / range;
  const double sin_b = sphere.radius / range;
  const double cos_b = std::sqrt(1.0 - sin_b * sin_b);
  const double k = cos_a * cos_a - sin_b * sin_b;
  const double focal = camera.focal_px;
  const double major = focal * sin_b * cos_b / k;
  const double minor = focal * sin_b / std::sqrt(k);
  const double reach = focal * sin_a * cos_a / k;
  Eigen::Vector2d way(0.0, 0.0);
  if (off_axis > 0.0) way = sphere.center.head<2>() / off_axis;
  const Eigen::Vector2d middle(0.5 * camera.extent.cols, 0.5 * camera.extent.rows);
  seen.center_px = middle + reach * Eigen::Vector2d(way.x(), -way.y());
  seen.radius_px = std::sqrt(major * minor);
  return seen;
}

SphereInSpace in_space(const Sphere& seen, const Camera& camera) {
  const Extent& extent = camera.extent;
  SphereInSpace sphere;
  sphere.center.head<2>() = extent.place(seen.center_px.y() - 0.5, seen.center_px.x() - 0.5);
  sphere.radius = seen.radius_px * extent.pitch;
  sphere.center.z() = sphere.radius;
  if (camera.model == Camera::Model::orthographic) return sphere;
  // The map from (x, y, radius) to the outline is close to a scaling: correcting by the difference
  // contracts by the share of the distance that the sphere is high, so 30 rounds are exact.
  for (int round = 0; round < 30; ++round) {
    const Sphere now = outline(sphere, camera);
    const Eigen::Vector2d miss_px = seen.center_px - now.center_px;
    sphere.center.x() += miss_px.x() * extent.pitch;
    sphere.center.y() -= miss_px.y() * extent.pitch;
    sphere.radius *= seen.radius_px / now.radius_px;
    sphere.center.z() = sphere.radius;
  }
  return sphere;
}

}  // namespace hada
