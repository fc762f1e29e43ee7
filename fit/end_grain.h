#pragma once

#include <string>
#include <vector>

#include "core/surface.h"
#include "fit/ring_rise.h"
#include "fit/ring_shape.h"

namespace hada {

/// What an end grain says of the stem it was cut from.
struct EndGrain {
  RingShape shape;                 // pith, lobes, radii to the middle of a rise; how sure they are
  RingRise rise;                   // at the boundaries
  Mask wood;                       // the picture without a plain background
  int level = 0;                   // of its lobes: 0 the same at every radius, 4 the most varied
  bool pith_inside = false;        // the picture
  std::vector<double> seen_share;  // of the sectors that a ring runs through, those that show it
};

/// Pith, shape and radii of the rings of an end grain.
///
/// A ring ends where dark latewood meets the light earlywood of the next. The pith is guessed from
/// the directions of the rings; the picture is laid flat around it; boundaries are followed from
/// sector to sector and fitted; lobes are added as long as they pay (BIC).
///
/// surface  with an albedo; a plain background around a disc is left out
/// throws   Error if there is no albedo, or no rings are seen
EndGrain end_grain(const Surface& surface);

}  // namespace hada
