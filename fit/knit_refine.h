#pragma once

#include <vector>

#include "core/surface.h"
#include "synth/bent_knit.h"

namespace hada {

/// Crossings as a photograph shows them.
struct RefinedCrossings {
  Places places;                 // in the frame of the picture, in its unit
  std::vector<double> likeness;  // correlation of each stitch with the drawn one, 1 at best
  double last_step_px = 0.0;     // root mean square, of the last round
};

/// Crossings for which the drawn loops of a knit are most like a photograph.
///
/// The whole piece is drawn with its loops through the crossings, in the light that explains the
/// photograph best (for each yarn linear in 1, the normal and the depth; the ground of one
/// brightness). What differs moves the crossings, all at once, each with the bilinear share that it
/// has in the places around it: Gauss and Newton, in smooth pictures first.
///
/// picture  its albedo, linear
/// knit     loop, yarn and yarns; its colour repeat from the lowest course upward
/// start    right to a quarter of a stitch or so
///
/// Source: Besnard, Hild and Roux, Exp. Mech. 46 (2006): digital image correlation on finite
/// elements of four corners, here with a drawn reference.
RefinedCrossings refined(const Surface& picture, const Knit<>& knit, const BentKnit& start);

}  // namespace hada
