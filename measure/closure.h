#pragma once

#include <vector>

#include <Eigen/Core>

namespace hada {

/// A crease that leaves a vertex, between two planes z = slope . (x, y).
struct ClosureWay {
  Eigen::Vector2d way;                      // seen from above, any length
  double way_sigma = 0.0;                   // of its direction, radians
  Eigen::Vector2d one, two;                 // slopes beside it
  double one_sigma = 0.0, two_sigma = 0.0;  // of each slope
  int one_facet = 0, two_facet = 0;         // planes with one number err together
};

struct Closure {
  double lack = 0.0;   // radians that the angles around the vertex lack to a full turn
  double sigma = 0.0;  // of that, from what is known of creases and planes
};

/// Paper that was flat closes around every vertex: its angles sum to a full turn in any fold. Each
/// crease rises as the mean of the planes beside it.
Closure closure_of(const std::vector<ClosureWay>& ways);

}  // namespace hada
