#include "synth/folded.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "core/error.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

struct Plane {
  std::vector<Vector2d> corners;
  Vector3d normal;
  Vector3d place;

  bool covers(const Vector2d& p) const {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector2d way = corners[(i + 1) % corners.size()] - corners[i], to = p - corners[i];
      if (way.x() * to.y() - way.y() * to.x() < 0.0) return false;
    }
    return true;
  }
  double height(const Vector2d& p) const {
    return place.z() - normal.head<2>().dot(p - place.head<2>()) / normal.z();
  }
};

std::vector<Plane> planes_of(const FoldFrame& folded) {
  std::vector<Plane> planes;
  for (const auto& face : folded.faces) {
    Plane plane;
    plane.place = folded.vertices[std::size_t(face[0])];
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vector3d &a = folded.vertices[std::size_t(face[i])],
                     &b = folded.vertices[std::size_t(face[(i + 1) % face.size()])];
      sum += (a - plane.place).cross(b - plane.place);
      plane.corners.push_back(a.head<2>());
    }
    plane.normal = sum.normalized();
    if (!(plane.normal.z() > 1e-6)) {
      throw Error("a face of the folded sheet shows its back or its edge; fold it less");
    }
    planes.push_back(std::move(plane));
  }
  if (planes.empty()) throw Error("the folded sheet has no faces; give faces_vertices");
  return planes;
}

}  // namespace

Surface folded_surface(const FoldFrame& folded, const Extent& extent) {
  const auto planes = planes_of(folded);
  Surface surface;
  surface.extent = extent;
  surface.mask = Mask(extent.rows, extent.cols, 0);
  surface.height = Grid<float>(extent.rows, extent.cols, 0.0f);
  surface.normals = NormalMap(extent.rows, extent.cols, Eigen::Vector3f::UnitZ());
  constexpr int finer = 4;
  double sum = 0.0;
  int count = 0;
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      Vector3d normal = Vector3d::Zero();
      double height = 0.0;
      int covered = 0;
      for (int k = 0; k < finer * finer; ++k) {
        const Vector2d p = extent.place(row + (k / finer + 0.5) / finer - 0.5,
                                        col + (k % finer + 0.5) / finer - 0.5);
        const auto on = std::find_if(planes.begin(), planes.end(),
                                     [&](const Plane& plane) { return plane.covers(p); });
        if (on == planes.end()) continue;
        normal += on->normal;
        height += on->height(p);
        ++covered;
      }
      if (2 * covered < finer * finer) continue;
      surface.mask(row, col) = 1;
      surface.normals(row, col) = normal.normalized().cast<float>();
      surface.height(row, col) = float(height / covered);
      sum += height / covered;
      ++count;
    }
  }
  if (count == 0) throw Error("the folded sheet lies outside the picture; move it to its centre");
  for (std::size_t i = 0; i < surface.mask.size(); ++i) {
    if (surface.mask[i]) surface.height[i] -= float(sum / count);
  }
  return surface;
}

}  // namespace hada
