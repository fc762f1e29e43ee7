#pragma once

#include "mechanics/wear.h"

namespace hada {

/// The springs of a worn knit as lines that stay outside the body: where a straight one would cut
/// through it, points lie in between, on the edges of the body's triangles.
struct TautYarns {
  struct Line {
    int from = 0, to = 0;  // points of the net
    Places between;
  };
  std::vector<Line> lines;  // along the courses first, then up the wales, in the order of points
  int inserted = 0;         // points in between, of all lines
  int cut = 0;              // lines that needed some
};

/// Each spring as a string that is pulled taut over the body, in the plane of the spring and the
/// body's normal: the upper hull of the edges that the plane crosses.
///
/// Source: Sakaguchi and Miyata (2013), section 6.3, which adds the crossed edges one by one.
TautYarns taut_yarns(const Body& body, const WornKnit& knit);

/// How many lines come deeper into the body than `allowed_mm` at one of some places along them.
int penetrating(const Body& body, const WornKnit& knit, const std::vector<TautYarns::Line>& lines,
                double allowed_mm);

/// The same lines without points in between.
std::vector<TautYarns::Line> straight_lines(const WornKnit& knit);

}  // namespace hada
