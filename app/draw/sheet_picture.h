#pragma once

#include "core/fold.h"
#include "core/image.h"

namespace hada {

/// From where a folded sheet is seen.
struct SheetView {
  double roll_deg = 0.0;  // in the plane of the picture, counter-clockwise, first of all
  double turn_deg = 0.0;  // about the upright axis of the picture
  double tilt_deg = 0.0;  // then the top edge away from the viewer
  int size_px = 480;      // of the longer side
};

/// A folded sheet: printed side coloured, back white, shaded by a light from the upper left; faces
/// that lie on each other in the order of their layers.
Image sheet_picture(const FoldFrame& folded, const SheetView& view = {});

}  // namespace hada
