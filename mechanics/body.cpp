#include "mechanics/body.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Geometry>

#include "core/error.h"

namespace hada {
namespace {

using Eigen::Vector3d;

// Height over longest side below which a triangle is a sliver: places in files are rounded to some
// 1e-6 of the body, which turns a flatter one by degrees.
constexpr double flattest = 1e-4;

TriangleMesh welded(const TriangleMesh& mesh) {
  TriangleMesh result;
  std::map<std::array<double, 3>, int> known;
  std::vector<int> number;
  for (const Vector3d& v : mesh.vertices_mm) {
    const auto [at, is_new] =
        known.try_emplace({v.x(), v.y(), v.z()}, int(result.vertices_mm.size()));
    if (is_new) result.vertices_mm.push_back(v);
    number.push_back(at->second);
  }
  // About the middle: that of an open mesh hangs on the point it is taken about.
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& v : result.vertices_mm) middle += v / double(result.vertices_mm.size());
  double volume = 0.0;
  for (auto t : mesh.triangles) {
    for (int& v : t) v = number[std::size_t(v)];
    const Vector3d &a = result.vertices_mm[std::size_t(t[0])],
                   &b = result.vertices_mm[std::size_t(t[1])],
                   &c = result.vertices_mm[std::size_t(t[2])];
    if ((b - a).cross(c - a).norm() == 0.0) continue;
    volume += (a - middle).dot((b - middle).cross(c - middle));
    result.triangles.push_back(t);
  }
  if (result.triangles.empty()) {
    throw Error("the body has no triangle with an area: give a mesh of a surface");
  }
  for (auto& t : result.triangles) {
    if (volume < 0.0) std::swap(t[1], t[2]);
  }
  return result;
}

std::array<Vector3d, 3> corners_of(const TriangleMesh& mesh, std::size_t triangle) {
  std::array<Vector3d, 3> corners;
  for (std::size_t s = 0; s < 3; ++s) {
    corners[s] = mesh.vertices_mm[std::size_t(mesh.triangles[triangle][s])];
  }
  return corners;
}

std::size_t longest_side(const std::array<Vector3d, 3>& corners) {
  std::size_t longest = 0;
  const auto length = [&](std::size_t s) { return (corners[(s + 1) % 3] - corners[s]).norm(); };
  for (const std::size_t s : {1, 2}) {
    if (length(s) > length(longest)) longest = s;
  }
  return longest;
}

std::vector<std::array<int, 3>> neighbours_of(const TriangleMesh& mesh) {
  std::vector<std::array<int, 3>> neighbours(mesh.triangles.size(), {-1, -1, -1});
  std::map<std::pair<int, int>, std::pair<int, int>> open;  // a side, and who has it
  for (int t = 0; t < int(mesh.triangles.size()); ++t) {
    const auto& corners = mesh.triangles[std::size_t(t)];
    for (int s = 0; s < 3; ++s) {
      const auto side = std::minmax(corners[std::size_t(s)], corners[std::size_t((s + 1) % 3)]);
      const auto [at, is_new] = open.try_emplace({side.first, side.second}, t, s);
      if (is_new) continue;
      const auto [other, other_side] = at->second;
      neighbours[std::size_t(t)][std::size_t(s)] = other;
      neighbours[std::size_t(other)][std::size_t(other_side)] = t;
    }
  }
  return neighbours;
}

}  // namespace

Body::Body(const TriangleMesh& mesh)
    : mesh_(welded(mesh)),
      tree_(mesh_),
      neighbours_(neighbours_of(mesh_)),
      corner_normals_(mesh_.vertices_mm.size(), Vector3d::Zero()) {
  std::vector<int> across;  // from each sliver over its longest side; else -1
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
    const auto p = corners_of(mesh_, i);
    const Vector3d twice_area = (p[1] - p[0]).cross(p[2] - p[0]);
    facet_normals_.push_back(twice_area.normalized());
    const std::size_t side = longest_side(p);
    const double height = twice_area.norm() / (p[(side + 1) % 3] - p[side]).squaredNorm();
    slivers_.push_back(height < flattest);
    across.push_back(slivers_[i] ? neighbours_[i][side] : -1);
  }
  // Slivers may lie against slivers: a few rounds reach a triangle with a face.
  for (int round = 0; round < 4; ++round) {
    for (std::size_t i = 0; i < across.size(); ++i) {
      if (across[i] >= 0) facet_normals_[i] = facet_normals_[std::size_t(across[i])];
    }
  }
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
    const auto& t = mesh_.triangles[i];
    const auto p = corners_of(mesh_, i);
    const Vector3d& normal = facet_normals_[i];
    for (std::size_t s = 0; s < 3; ++s) {
      const Vector3d u = p[(s + 1) % 3] - p[s], v = p[(s + 2) % 3] - p[s];
      corner_normals_[std::size_t(t[s])] += std::atan2(u.cross(v).norm(), u.dot(v)) * normal;
    }
  }
  for (Vector3d& normal : corner_normals_) normal.normalize();
}

Vector3d Body::normal(const MeshPlace& at) const {
  const auto& t = mesh_.triangles[std::size_t(at.triangle)];
  Vector3d sum = Vector3d::Zero();
  for (int s = 0; s < 3; ++s) {
    sum += at.weights[s] * corner_normals_[std::size_t(t[std::size_t(s)])];
  }
  const double length = sum.norm();
  return length > 1e-6 ? Vector3d(sum / length) : facet_normal(at.triangle);
}

Vector3d Body::smooth_place(const MeshPlace& at) const {
  const auto& t = mesh_.triangles[std::size_t(at.triangle)];
  Vector3d place = at.place;
  for (std::size_t s = 0; s < 3; ++s) {
    const Vector3d& normal = corner_normals_[std::size_t(t[s])];
    const Vector3d& corner = mesh_.vertices_mm[std::size_t(t[s])];
    place += 0.5 * at.weights[int(s)] * normal.dot(corner - at.place) * normal;
  }
  return place;
}

Eigen::Matrix3d Body::curvature(const MeshPlace& at) const {
  if (slivers_[std::size_t(at.triangle)]) return Eigen::Matrix3d::Zero();  // too thin to tell
  const auto& t = mesh_.triangles[std::size_t(at.triangle)];
  const auto corner = [&](std::size_t s) { return mesh_.vertices_mm[std::size_t(t[s])]; };
  const auto normal_at = [&](std::size_t s) { return corner_normals_[std::size_t(t[s])]; };
  // The linear map that takes two sides to the differences of their normals, and the triangle's
  // normal to nothing.
  Eigen::Matrix3d sides, changes;
  sides << corner(1) - corner(0), corner(2) - corner(0), facet_normal(at.triangle);
  changes << normal_at(1) - normal_at(0), normal_at(2) - normal_at(0), Vector3d::Zero();
  const Eigen::Matrix3d map = changes * sides.inverse();
  return 0.5 * (map + map.transpose());
}

double Body::depth(const Vector3d& point, int guess) const {
  const MeshPlace at = tree_.closest(point, guess);
  const auto& t = mesh_.triangles[std::size_t(at.triangle)];
  constexpr double edge = 1e-9;  // of the weights: on a side, or in a corner
  Vector3d normal = facet_normal(at.triangle);
  for (std::size_t s = 0; s < 3; ++s) {
    if (at.weights[int(s)] > 1.0 - edge) normal = corner_normals_[std::size_t(t[s])];
    const int beyond = neighbours_[std::size_t(at.triangle)][(s + 1) % 3];  // opposite of s
    if (at.weights[int(s)] < edge && at.weights.maxCoeff() <= 1.0 - edge && beyond >= 0) {
      normal += facet_normal(beyond);
    }
  }
  return std::copysign(at.distance, (at.place - point).dot(normal));
}

}  // namespace hada
