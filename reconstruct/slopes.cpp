#include "reconstruct/slopes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"

namespace hada {
namespace {

constexpr float least_facing = 0.02f;  // cosine to the ray, below which a slope means nothing

}  // namespace

std::optional<PinHole> pin_hole_of(const Camera& camera, const Eigen::Vector2i& offset_px) {
  if (camera.model == Camera::Model::orthographic) return {};
  const Eigen::Vector2d middle(0.5 * camera.extent.cols, 0.5 * camera.extent.rows);
  return PinHole{Eigen::Vector2d::Constant(camera.focal_px), middle - offset_px.cast<double>()};
}

SlopeMap slopes_of(const NormalMap& normals, const Mask& mask,
                   const std::optional<PinHole>& pin_hole) {
  SlopeMap slopes(mask.rows(), mask.cols(), Eigen::Vector2f::Zero());
  for_each_index(mask.rows(), [&](int row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      const Eigen::Vector3f& normal = normals(row, col);
      assert(normal.z() > 0.0f);
      if (!pin_hole) {
        slopes(row, col) = -normal.head<2>() / normal.z();
        continue;
      }
      // Everything along y is scaled as if a pixel were square: the lattice counts pixels.
      const Eigen::Vector2d& focal = pin_hole->focal_px;
      const auto x = float((col + 0.5 - pin_hole->centre_px.x()) / focal.x());
      const auto y = float((pin_hole->centre_px.y() - row - 0.5) / focal.y());
      const float facing = std::max(normal.z() - normal.x() * x - normal.y() * y, least_facing);
      slopes(row, col) = {-normal.x() / facing,
                          -normal.y() / facing * float(focal.x() / focal.y())};
    }
  });
  return slopes;
}

void height_from_log_depth(Grid<float>& w, double distance) {
  for_each_index(w.rows(), [&](int row) {
    for (float& value : w.row(row)) value = float(-distance * std::expm1(-value / distance));
  });
}

}  // namespace hada
