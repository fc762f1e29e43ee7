#pragma once

#include <vector>

#include "mechanics/wear.h"

namespace hada {

/// The line in which a level plane cuts a body.
struct Outline {
  Eigen::Vector3d middle;  // the mean place of the line
  double length = 0.0;
};
/// throws  Error if there is none at that height
Outline outline_at(const Body& body, int axis, double height);

/// Between which heights a tube is drawn over a body.
struct TubeSpan {
  double from = 0.0;
  double to = 0.0;
  double reach = 0.0;  // a length that leads out of the body
};

/// The heights that the options name, or all of the body but a twentieth at each end.
/// throws  Error if they are not heights of the body, the lower one first
TubeSpan tube_span(const Body& body, const WearOptions& options);

/// Where the points of a tube begin: even turns around the body at even heights, seen from the
/// middle of its outline there.
/// throws  Error if the outline is not closed around its middle
std::vector<MeshPlace> drawn_over(const Body& body, const WearOptions& options,
                                  const TubeSpan& span);

/// The smallest length around the body of a ring of those points.
double smallest_girth(const std::vector<MeshPlace>& places, const WearOptions& options);

}  // namespace hada
