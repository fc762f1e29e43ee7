#pragma once

#include "core/surface.h"
#include "fit/fit.h"
#include "synth/wood.h"

namespace hada {

/// The stem that explains the picture of an end grain: pith, lobes, radii of the rings, and how a
/// ring changes its colour. What an end grain does not show keeps its default, with a sigma that
/// says that nothing is known, and a remark.
///
/// Frame: origin at the centre of the picture, x right, y up, the cut at z = 0.
/// throws  what `end_grain` does
Fit<Wood<>> fit_wood(const Surface& surface);

}  // namespace hada
