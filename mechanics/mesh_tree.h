#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/mesh.h"

namespace hada {

/// A place on a mesh: its triangle, and how much each corner counts.
struct MeshPlace {
  int triangle = -1;  // -1: none
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double distance = 0.0;  // from where it was asked
};

/// The triangles of a mesh in a tree of boxes, for the two questions that geometry asks of them.
///
/// Embree answers them faster, but its library would cost every start of the program 4 ms.
class MeshTree {
 public:
  /// The mesh must outlive the tree.
  explicit MeshTree(const TriangleMesh& mesh);

  /// The nearest place of the mesh. guess: a triangle that may be near, or -1
  ///
  /// Source: Ericson, Real-Time Collision Detection (2005), 5.1.5.
  MeshPlace closest(const Eigen::Vector3d& point, int guess = -1) const;

  /// The first triangle that a ray meets, from either side.
  /// direction  of any length: distances are in units of it
  ///
  /// Source: Moeller and Trumbore, J. Graphics Tools 2 (1997).
  MeshPlace first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;

 private:
  struct Node {
    Eigen::Vector3d low, high;
    int first = 0;  // of its triangles, or its second child (the first one is next in line)
    int count = 0;  // 0: not a leaf
  };
  void build(int first, int count);
  void try_closest(const Eigen::Vector3d& point, int triangle, MeshPlace& best) const;

  const TriangleMesh& mesh_;
  std::vector<int> order_;
  std::vector<Eigen::Vector3d> middles_;
  std::vector<Node> nodes_;
};

}  // namespace hada
