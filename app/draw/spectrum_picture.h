#pragma once

#include "app/draw/maps.h"
#include "measure/spectrum.h"

namespace hada {

/// The part of a spectrum that is worth looking at, and its colours. Spectra that are compared
/// share one.
struct SpectrumStyle {
  double highest_frequency = 0.5;  // at the border of the picture, cycles per unit
  Range log_power;                 // decades (log10 of unit^4) from dark to light
};

/// Up to the frequency that holds all but a thousandth of the power, six decades down from the top.
SpectrumStyle spectrum_style(const Spectrum& spectrum);

/// The logarithm of the power: frequency 0 in the middle, fx to the right, fy up, a square.
Image spectrum_picture(const Spectrum& spectrum, const SpectrumStyle& style, int side_px = 320);

}  // namespace hada
