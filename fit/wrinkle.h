#pragma once

#include <vector>

#include "core/surface.h"
#include "fit/fit.h"
#include "fit/ridges.h"
#include "measure/spectrum.h"
#include "synth/wrinkle.h"

namespace hada {

struct WrinkleFitOptions {
  int components = 0;         // how many noise functions; 0: chosen by BIC
  int most_components = 4;    // the largest number that BIC may choose
  int starts = 8;             // at least 6
  double lens_blur_px = 0.0;  // standard deviation of the lens's point spread, where it is known
  bool ridges = false;        // whether skew, tail and sharpness are fitted too, in seconds
  FitProgress progress = {};
};

struct WrinkleFit : Fit<Wrinkle<>> {
  RidgeEvidence ridges;  // of nothing where they were not asked for
};

/// The same wrinkles as everyone would write them: long >= short, long components first, angles in
/// [0, pi).
Wrinkle<> canonical(Wrinkle<> wrinkle);

/// The wrinkle noise whose spectrum agrees best with that of the height of `surface`.
///
/// Whittle likelihood over cells of the tapered periodogram, started from its rings and sectors,
/// bounded, the best of several starts; sigma from the Fisher information. What the map has beyond
/// its spectrum is told by `fit_ridges`, where it is asked. A picture without height whose spectrum
/// is no wrinkle noise's gets the nearest by `closest_wrinkle`.
///
/// throws  Error if the surface has no height, or its mask is smaller than 32 x 32 pixels
///
/// Source: Kiso et al., section 5.2 (rings and sectors as starts); Whittle, Ark. Mat. 2 (1953).
WrinkleFit fit_wrinkle(const Surface& surface, const WrinkleFitOptions& options = {});

}  // namespace hada
