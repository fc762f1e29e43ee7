#pragma once

#include "measure/hump_mixture.h"

namespace hada {

/// The humps of a spectrum: one after another where the likelihood rises most steeply, each time
/// all of them fitted together, until another is not worth its parameters (BIC).
///
/// patches  of a spectrum whose taper reaches to the middle, so that strong waves do not leak into
///          weak ones (`SpectrumOptions::taper` 1)
/// most     humps at most
HumpMixture humps_of(const SpectralPatches& patches, int most);

}  // namespace hada
