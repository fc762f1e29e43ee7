#pragma once

#include <optional>

#include "measure/polar.h"

namespace hada {

/// How the spectrum of a surface falls from long waves to short ones: flat up to a corner, then by
/// a power, down to a white floor. In the units of the spectrum.
struct Decay {
  double plateau = 0.0;  // power spectral density of the longest waves, unit^4
  double corner = 0.0;   // cycles per unit; beyond, the density falls as f^-slope
  double slope = 0.0;
  double floor =
      0.0;  // power spectral density that is the same everywhere, unit^4; 0 if there is none
  double plateau_sigma = 0.0, corner_sigma = 0.0, slope_sigma = 0.0, floor_sigma = 0.0;
  double misfit =
      0.0;  // what rings scatter about the curve by over what chance makes of them; 1 if it holds

  /// Hurst exponent of a self-affine surface, (slope - 2) / 2; none where the spectrum falls too
  /// slowly or too fast for one (outside 0 to 1 by more than two sigma).
  std::optional<double> hurst() const;
};

/// The curve plateau / (1 + (f / corner)^2)^(slope / 2) + floor that explains the densities of the
/// rings best, each a gamma variable with the standard error that it has (the deviance of a mean
/// periodogram, Whittle). Sigma is widened by the misfit where that is above 1.
///
/// returns  none for fewer than 8 rings that hold power
///
/// Source: the K-correlation or ABC model of Church and Takacs, Handbook of Optics 1 (1995);
/// Hurst exponent of an areal spectrum: Persson et al., J. Phys.: Condens. Matter 17 (2005).
std::optional<Decay> decay_of(const Rings& rings);

}  // namespace hada
