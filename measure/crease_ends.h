#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "measure/crease_edge.h"

namespace hada {

/// What is known of a crease before its ends are.
struct CreaseCandidate {
  int first, second;  // the facets that it joins
  CreaseEdge edge;
  double from, to;  // along the edge
};

/// The direction of an edge.
inline Eigen::Vector2d along(const CreaseEdge& edge) {
  return {-edge.normal.y(), edge.normal.x()};
}

/// The ends of all creases.
struct CreaseEnds {
  std::vector<Eigen::Vector2d> places;  // of the vertices
  std::vector<std::array<int, 2>> of;   // of each crease: vertices at its start and end
  std::vector<int> side;                // of each vertex: the side of the outline, or -1
};

/// Puts the ends of creases where they meet the outline, or each other: several that end within
/// twice the tolerance share the point that is nearest to all their lines.
CreaseEnds ends_of(const std::vector<CreaseCandidate>& candidates,
                   const std::vector<Eigen::Vector2d>& outline, double tolerance);

}  // namespace hada
