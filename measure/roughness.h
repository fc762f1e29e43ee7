#pragma once

#include "core/grid.h"

namespace hada {

/// Areal roughness of a height map; the names are those of ISO 25178-2.
struct Roughness {
  double Sa = 0.0;   // mean absolute height, unit
  double Sq = 0.0;   // root mean square height, unit
  double Sp = 0.0;   // highest peak, unit
  double Sv = 0.0;   // deepest valley (positive), unit
  double Sz = 0.0;   // Sp + Sv, unit
  double Ssk = 0.0;  // skewness
  double Sku = 0.0;  // kurtosis, 3 for a Gaussian surface
  double Sdq = 0.0;  // root mean square slope
  double Sdr = 0.0;  // developed area over projected area, minus 1
  double Sal = 0.0;  // shortest lag at which the autocorrelation falls to 0.2, unit
  double Str = 0.0;  // Sal over the longest such lag, 0 to 1
  double Std = 0.0;  // direction of the texture (lay), counter-clockwise from +x, radians, [0, pi)
};

/// The roughness of `height` inside `mask`, about its mean.
///
/// height, pitch  in one unit
/// throws         Error if fewer than 64 pixels are in the mask
Roughness roughness(const Grid<float>& height, const Mask& mask, double pitch);

}  // namespace hada
