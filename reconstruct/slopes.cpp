#include "reconstruct/slopes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/parallel.h"

namespace hada {
namespace {

// Where the ray that meets pixel (row, col) is, y up, one unit in front of the pin-hole.
Eigen::Vector2f ray_at(const PinHole& pin_hole, int row, int col) {
  return {float((col + 0.5 - pin_hole.centre_px.x()) / pin_hole.focal_px.x()),
          float((pin_hole.centre_px.y() - row - 0.5) / pin_hole.focal_px.y())};
}

float facing(const Eigen::Vector3f& normal, const std::optional<PinHole>& pin_hole, int row,
             int col) {
  if (!pin_hole) return normal.z();
  const Eigen::Vector2f ray = ray_at(*pin_hole, row, col);
  return normal.z() - normal.x() * ray.x() - normal.y() * ray.y();
}

}  // namespace

std::optional<PinHole> pin_hole_of(const Camera& camera, const Eigen::Vector2i& offset_px) {
  if (camera.model == Camera::Model::orthographic) return {};
  const Eigen::Vector2d middle(0.5 * camera.extent.cols, 0.5 * camera.extent.rows);
  return PinHole{Eigen::Vector2d::Constant(camera.focal_px), middle - offset_px.cast<double>()};
}

SlopeMap slopes_of(const NormalMap& normals, const Mask& mask,
                   const std::optional<PinHole>& pin_hole, float least) {
  SlopeMap slopes(mask.rows(), mask.cols(), Eigen::Vector2f::Zero(), normals.memory());
  for_each_index(mask.rows(), [&](int row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      const Eigen::Vector3f& normal = normals(row, col);
      assert(normal.z() > 0.0f);
      // Everything along y is scaled as if a pixel were square: the lattice counts pixels.
      const double aspect = pin_hole ? pin_hole->focal_px.x() / pin_hole->focal_px.y() : 1.0;
      const float m = std::max(facing(normal, pin_hole, row, col), least);
      slopes(row, col) = {-normal.x() / m, -normal.y() / m * float(aspect)};
    }
  });
  return slopes;
}

Grid<float> facing_of(const NormalMap& normals, const Mask& mask,
                      const std::optional<PinHole>& pin_hole, float least) {
  Grid<float> result(mask.rows(), mask.cols());
  for_each_index(mask.rows(), [&](int row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      const Eigen::Vector3f& normal = normals(row, col);
      result(row, col) = std::max(facing(normal, pin_hole, row, col), least);
    }
  });
  return result;
}

double farthest_off_axis_deg(const PinHole& pin_hole, const Mask& mask) {
  float tangent = 0.0f;
  for (const int row : {0, mask.rows() - 1}) {
    for (const int col : {0, mask.cols() - 1}) {
      tangent = std::max(tangent, ray_at(pin_hole, row, col).norm());
    }
  }
  return std::atan(double(tangent)) * 180.0 / std::numbers::pi;
}

double share_hidden(const NormalMap& normals, const Mask& mask, const PinHole& pin_hole) {
  constexpr double clearly = -0.1;  // sine of the angle; outlines are a little off
  std::size_t hidden = 0;
  std::size_t all = 0;
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      const Eigen::Vector3f& normal = normals(row, col);
      const float length = std::hypot(1.0f, ray_at(pin_hole, row, col).norm());
      hidden += double(facing(normal, pin_hole, row, col)) < clearly * double(length) ? 1 : 0;
      ++all;
    }
  }
  return double(hidden) / double(std::max(all, std::size_t(1)));
}

void height_from_log_depth(Grid<float>& w, double distance) {
  for_each_index(w.rows(), [&](int row) {
    for (float& value : w.row(row)) value = float(-distance * std::expm1(-value / distance));
  });
}

}  // namespace hada
