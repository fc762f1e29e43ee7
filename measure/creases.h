#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/fold.h"
#include "core/light_stack.h"
#include "core/surface.h"
#include "measure/facets.h"

namespace hada {

/// A crease of a re-opened sheet as it was seen.
struct MeasuredCrease {
  int first = 0, second = 0;  // the facets that it joins
  Eigen::Vector2d from, to;   // its ends, in the frame and unit of the surface
  double fold_angle = 0.0;    // radians: valleys, which open to the viewer, > 0
  double fold_angle_sigma = 0.0;
  double offset_sigma = 0.0;  // of the line, across it, in the unit of the surface
  double width = 0.0;         // standard deviation of the bend, across the line
  double width_sigma = 0.0;
};

/// A vertex inside the sheet where creases meet.
struct MeasuredVertex {
  Eigen::Vector2d place;
  int creases = 0;
  double closure = 0.0;  // radians that the angles around it lack to a full turn
  double closure_sigma = 0.0;
};

struct MeasuredCreases {
  std::vector<MeasuredCrease> creases;
  std::vector<MeasuredVertex> inner_vertices;
  std::vector<double> lights_turned;  // how far the sheet itself corrected each light, radians;
                                      // empty if it could not
  FoldFrame frame;  // the sheet in space with its border: vertices, edges, angles, no faces yet
};

/// The creases between the flat parts of a sheet.
///
/// A fold angle is the angle between the planes on both sides. A line is where the slopes pass from
/// one plane to the other: the step of all pixels near it is fitted by a straight edge with a soft
/// bend, which places it to a small part of a pixel.
///
/// stack   the pictures that the surface was made from, if they are there: the brightness of its
///         facets corrects their lights, and the planes with them
/// throws  Error as `facets_of` does
MeasuredCreases measured_creases(const Surface& surface, const FacetOptions& options = {},
                                 const LightStack* stack = nullptr);

}  // namespace hada
