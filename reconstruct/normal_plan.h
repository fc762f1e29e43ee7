#pragma once

#include "reconstruct/tile_solver.h"
#include "reconstruct/tile_source.h"

namespace hada {

/// Learns off some 4000 pixels, spread evenly over the mask, what all pixels have in common: the
/// noise law, and for `adaptive` the shared terms.
///
/// The shading curve is used where it takes 3 % at least of the squared residuals away, and there
/// are six lights or more; the light between folds where `source.bounce` is given. Its coefficient
/// lies between 0 and what an albedo of 1 at the brightest pixels allows.
NormalPlan plan_normals(const TileSource& source, Estimator estimator);

}  // namespace hada
