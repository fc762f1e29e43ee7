#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "sheet/sheet.h"

namespace hada {

/// Puts a vertex on an edge, `share` of the way from its origin; the part beyond becomes a new
/// edge. returns  the vertex
int split_edge(Sheet& sheet, int edge, double share);

/// Cuts a face from one of its corners to another; what lies to the left of that becomes a new
/// face. returns  the edge
int split_face(Sheet& sheet, int face, int from, int to, Crease crease);

/// Where a crease is drawn: the zero of `side`, as far as `within` says.
struct CreaseCut {
  std::function<double(const Eigen::Vector3d&)> side;  // a distance, positive to its left
  std::function<bool(const Eigen::Vector3d&)> within;
  double tolerance = 1e-9;  // closer vertices are taken to lie on it
};

/// The straight cut from `from` to `to` seen from above, over places with z = 0.
CreaseCut straight_cut(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double tolerance);

/// Creases every face that the cut crosses from side to side; a face that it enters and does not
/// leave stays whole, as in the paper.
///
/// where    of the vertices: what the cut is compared with (flat, folded, or a flat state)
/// chosen   faces that may be creased; empty: all
/// returns  the edges along the cut, old ones that lie on it among them
std::vector<int> insert_crease(Sheet& sheet, std::vector<Eigen::Vector3d> where,
                               const CreaseCut& cut, Crease crease,
                               const std::vector<bool>& chosen = {});

}  // namespace hada
