#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace hada {

/// A surface of triangles in space, right-handed; seen from outside, corners run counter-clockwise.
///
/// `uv` is empty or holds one place on the picture for each vertex: u to the right, v up, the
/// picture fills [0, 1] x [0, 1]. Where a picture has a seam, vertices lie there twice.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices_mm;
  std::vector<std::array<int, 3>> triangles;
  std::vector<Eigen::Vector2d> uv;

  bool operator==(const TriangleMesh&) const = default;
};

}  // namespace hada
