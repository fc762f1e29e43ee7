#pragma once

#include "measure/hump_mixture.h"

namespace hada {

/// The humps of a spectrum: one after another where the likelihood rises most steeply, each time
/// all of them fitted together, until another is not worth its parameters (BIC).
///
/// spectrum  of a map whose taper reaches to the middle, so that strong waves do not leak into weak
///           ones (`SpectrumOptions::taper` 1)
/// most      humps at most
HumpMixture humps_of(const Spectrum& spectrum, int most);

}  // namespace hada
