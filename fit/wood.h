#pragma once

#include "core/surface.h"
#include "fit/end_grain.h"
#include "fit/face_grain.h"
#include "fit/fit.h"
#include "synth/wood.h"

namespace hada {

/// What the first picture shows.
enum class WoodView {
  automatic,  // a face if fibres run up the picture, else an end grain
  end_grain,
  face,  // cut along the stem, the stem upright in the picture
};

struct WoodFitOptions {
  WoodView view = WoodView::automatic;
  const Surface* face = nullptr;  // of the same stem, next to an end grain
};

/// The stem that explains the picture of an end grain, of a face, or of both.
///
/// An end grain shows pith, lobes, radii of the rings and how a ring changes its colour; a face
/// shows how fibres lean. What the pictures do not show keeps its default, with a sigma that says
/// that nothing is known, and a remark. The length of an interlock that no rings are known for is
/// counted in mm.
///
/// Frame: origin at the centre of the end grain, x right, y up, the cut at z = 0; of a face alone,
/// z is 0 at its centre.
/// throws  what `end_grain` and `face_grain` do
Fit<Wood<>> fit_wood(const Surface& surface, const WoodFitOptions& options = {});

/// Writes into `fit` how fibres lean on a tangential face that is seen from outside.
void add_face(Fit<Wood<>>& fit, const FaceGrain& grain);

/// What an end grain that has been read already says, `grain` of `surface`; rings reach to the
/// middle of their rise, not to where it begins as those of `fit_wood` do.
Fit<Wood<>> wood_of(const EndGrain& grain, const Surface& surface);

}  // namespace hada
