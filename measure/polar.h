#pragma once

#include <cmath>
#include <vector>

#include "measure/spectrum.h"

namespace hada {

/// Power summed over rings of equal width, from frequency 0 to Nyquist.
struct Rings {
  std::vector<double> frequency;  // middle of the ring, cycles per unit
  std::vector<double> power;      // share of the variance in the ring, unit^2
  std::vector<double> density;    // mean power spectral density in the ring, unit^4
  std::vector<double> sigma;      // standard error of `density`
  std::vector<double> low, high;  // between which its expectation lies, 95 % (`power_interval`)
  std::vector<int> count;         // ordinates in the ring
};

/// Power summed over sectors of equal angle, [0, pi): a real map has the same power at f and -f.
struct Sectors {
  std::vector<double> angle;      // middle of the sector, counter-clockwise from +x, radians
  std::vector<double> power;      // share of the variance in the sector, unit^2
  std::vector<double> density;    // mean power spectral density in the sector, unit^4
  std::vector<double> sigma;      // standard error of `density`
  std::vector<double> low, high;  // between which its expectation lies, 95 % (`power_interval`)
  std::vector<int> count;         // ordinates in the sector, shares added up
};

/// Rings [R, R + dR) up to the Nyquist frequency; fewer than `count` where a ring would be thinner
/// than the step of the frequencies. Source: Kiso et al., section 5.2, fig. 7a.
Rings rings(const Spectrum& spectrum, int count = 64);

/// Sectors [theta, theta + dtheta), of the frequencies from `low` to below `high` (cycles per unit)
/// within the Nyquist circle, frequency 0 left out. An ordinate is as wide as the step to the next:
/// near frequency 0, where that is wider than a sector, its power goes to all that it covers, each
/// by its share. Source: Kiso et al., section 5.2, fig. 7b.
Sectors sectors(const Spectrum& spectrum, int count = 36, double low = 0.0, double high = HUGE_VAL);

/// Indices of local maxima (cyclic for sectors), the highest first, at most `most`.
std::vector<int> peaks(const std::vector<double>& power, int most, bool cyclic);

}  // namespace hada
