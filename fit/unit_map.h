#pragma once

#include "core/surface.h"
#include "fit/fit.h"
#include "synth/wrinkle.h"

namespace hada {

/// What a map is measured in by a fit that is to find the same at any scale: bounds of fields and
/// of solvers are lengths, and a map of micrometres lies as near to them as one of metres.
struct MapUnits {
  double height = 1.0;  // standard deviation of the height; 1 for a picture
  double length = 1.0;  // pitch
};

/// throws  nothing; a flat map has the height 1
MapUnits units_of(const Surface& surface);

/// What a wrinkle fit looks at of `surface`, with pitch 1 and heights of standard deviation 1.
Surface in_units(const Surface& surface, const MapUnits& units);

/// A fit to a map in `units`, as a fit to the map itself: the covariance, of logarithms, stays.
void give_back_units(Fit<Wrinkle<>>& fit, const MapUnits& units);

}  // namespace hada
