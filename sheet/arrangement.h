#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace hada {

/// Lines in the plane cut at all their crossings, and the cells between them.
struct Arrangement {
  std::vector<Eigen::Vector2d> points;
  std::vector<int> point_of;                  // of each vertex given: points closer than the snap
                                              // distance are one
  std::vector<std::array<int, 2>> segments;   // between points; they meet at points only
  std::vector<std::vector<int>> segments_of;  // of each line given, from its start to its end
  std::vector<std::array<int, 2>> cells_of;   // of each segment: left and right, -1 is outside
  std::vector<std::vector<int>> cells;        // points around a cell, counter-clockwise
};

/// vertices, lines  lines join two vertices each; they may cross, touch and overlap
/// snap             points closer than this are taken for one, a point this close to a line for one
///                  on it, > 0
Arrangement arrangement(const std::vector<Eigen::Vector2d>& vertices,
                        const std::vector<std::array<int, 2>>& lines, double snap);

/// The distance below which vertices and lines should be taken to touch: within the widest gap (by
/// ratio) of the distances from vertices to vertices and lines, so that rounding lies below it and
/// what was drawn lies above.
///
/// noise  distances up to this are known to be rounding
double snap_distance(const std::vector<Eigen::Vector2d>& vertices,
                     const std::vector<std::array<int, 2>>& lines, double noise = 0.0);

/// The larger side of the smallest upright rectangle around the points.
double size_of(const std::vector<Eigen::Vector2d>& points);

}  // namespace hada
