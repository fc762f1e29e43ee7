#pragma once

#include <array>
#include <vector>

#include "core/mesh.h"
#include "mechanics/mesh_tree.h"

namespace hada {

/// What a knit is worn on: a surface with an inside. It is copied and stays where it is.
class Body {
 public:
  /// Corners that lie in one place become one, triangles without area are left out, and all are
  /// turned so that the volume is positive. Slivers, whose own normal is rounding, lie in the plane
  /// of the triangle across their longest side.
  ///
  /// Holes are allowed where no knit comes near (a leg may be open at its top).
  /// throws  Error if nothing is left
  explicit Body(const TriangleMesh& mesh);
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;

  const TriangleMesh& mesh() const { return mesh_; }
  const MeshTree& tree() const { return tree_; }
  /// Across the side from corner s to corner s + 1 of each triangle; -1 where there is none.
  const std::vector<std::array<int, 3>>& neighbours() const { return neighbours_; }

  /// Unit, outward, of the flat triangle.
  const Eigen::Vector3d& facet_normal(int triangle) const {
    return facet_normals_[std::size_t(triangle)];
  }
  /// Unit, outward, mixed from those of the corners: what the body looks like from afar.
  Eigen::Vector3d normal(const MeshPlace& at) const;
  /// The place of the smooth surface that the flat triangle stands for; what `normal` is normal to.
  ///
  /// Source: Boubekeur and Alexa, Phong tessellation, ACM TOG 27 (2008), with half of its shift:
  /// that is the parabola whose slopes at the corners are those of their normals.
  Eigen::Vector3d smooth_place(const MeshPlace& at) const;
  /// How that normal changes with the place: a symmetric map of tangents, positive where the body
  /// bulges.
  Eigen::Matrix3d curvature(const MeshPlace& at) const;
  /// How far a point lies inside the body, < 0 outside.
  ///
  /// Source: Baerentzen and Aanaes, Signed distance computation using the angle weighted
  /// pseudonormal, IEEE TVCG 11 (2005), for corners; for sides the mean of the two triangles.
  double depth(const Eigen::Vector3d& point, int guess = -1) const;

 private:
  TriangleMesh mesh_;
  MeshTree tree_;
  std::vector<std::array<int, 3>> neighbours_;
  std::vector<bool> slivers_;
  std::vector<Eigen::Vector3d> facet_normals_, corner_normals_;
};

}  // namespace hada
