#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/grid.h"

namespace hada {

/// A circle in a picture, (u, v) in px.
struct Circle {
  Eigen::Vector2d center{0.0, 0.0};
  double radius = 0.0;
  double coverage = 0.0;  // share of its circumference on which an edge was seen, 0 to 1
  double scatter = 0.0;   // root mean square distance of those edge points from it, px
  double sigma = 0.0;     // standard deviation of centre and radius, px; 0: by the scatter
};

struct CircleSearch {
  double smallest_radius = 8.0;  // px
  double largest_radius = 1e9;   // px; at most half the shorter side counts
  int most = 60;                 // candidates returned
  double longest_side = 400.0;   // px; larger pictures are reduced, as far as the smallest allows
};

/// Circles that the edges of `picture` may belong to, the best supported first.
///
/// Every edge pixel votes for the centres that lie along its gradient (Hough), on a copy of the
/// picture reduced to `longest_side`. Edges are judged against their surroundings, so that a faint
/// outline on a plain table counts as much as a bold one beside a print.
///
/// Source: Ballard, Pattern Recognition 13 (1981); Kimme, Ballard, Sklansky, CACM 18 (1975).
std::vector<Circle> circle_candidates(const Grid<float>& picture, const CircleSearch& search = {});

/// The circle near `start` that the steepest points along its radii lie on, to sub-pixel precision.
///
/// window   how far from the start's radius the edge may be, as a share of it
/// returns  a coverage of 0 if fewer than a quarter of the radii agree on any circle
Circle refined(const Grid<float>& picture, const Circle& start, double window);

/// The circle that a mask is, to half a pixel; nothing if more than 3 % of it lies outside one of
/// its area around its middle.
std::optional<Circle> disc_of(const Mask& mask);

}  // namespace hada
