#pragma once

#include "core/grid.h"
#include "measure/spectrum.h"

namespace hada {

/// Which hump of a spectrum every ordinate belongs to.
struct SpectralHills {
  Grid<int> of_ordinate;  // number of the hump; -1 beyond Nyquist, at 0 and on far slopes
  int count = 0;
};

/// The humps of the power per octave and angle, divided along the valleys between them.
///
/// The power is smoothed over 8 % of its frequency, or one step of the spectrum if that is more. A
/// hump stands out by three deviations of what chance does to a smoothed logarithm, and reaches
/// down to 1 % of its summit: on farther slopes other humps shine in.
SpectralHills spectral_hills(const Spectrum& spectrum);

}  // namespace hada
