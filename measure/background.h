#pragma once

#include "core/grid.h"

namespace hada {

/// `mask` without the plain background around a disc.
///
/// A background is there if most of the border of the picture has one brightness; it is what
/// hangs together with the border and has that brightness, and `margin_px` more. Where the border
/// is not plain, as on a block that fills the picture, the mask comes back as it is.
Mask without_background(const Grid<float>& brightness, const Mask& mask, int margin_px);

}  // namespace hada
