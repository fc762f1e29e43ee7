#pragma once

#include "core/fold.h"
#include "core/surface.h"

namespace hada {

/// The surface of a folded sheet that nowhere lies over itself, seen from above.
///
/// A pixel is the mean of what 16 places in it show, so that a crease is as soft as a pixel.
///
/// folded  vertices in the unit and frame of `extent`; faces as they are
/// returns height, zero-mean, and normals; the mask where the sheet covers at least half of a pixel
/// throws  Error if the sheet has no faces, shows its back, or lies outside `extent`
Surface folded_surface(const FoldFrame& folded, const Extent& extent);

}  // namespace hada
