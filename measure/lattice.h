#pragma once

#include <vector>

#include <Eigen/Core>

#include "measure/spectrum.h"

namespace hada {

/// A place where the spectrum of a map stands out, between the bins. One of each pair +f and -f.
struct SpectralPeak {
  Eigen::Vector2d
      frequency;            // cycles per unit, x right, y up; its half plane is y > 0 or y = 0 < x
  double power = 0.0;       // at the peak
  double prominence = 0.0;  // that power over the median of its surroundings
};

struct PeakOptions {
  double least_prominence = 20.0;
  double least_share = 1e-4;  // of the power of the strongest peak
  int most = 60;
};

/// The peaks of `spectrum`, the strongest first.
///
/// The map should be measured with a taper of 1 (a Hann window): its lobe is nearly a parabola in
/// the logarithm, whose vertex is the place of the peak.
std::vector<SpectralPeak> spectral_peaks(const Spectrum& spectrum, const PeakOptions& options = {});

/// The two shortest vectors whose whole combinations are the peaks of a periodic map.
struct Lattice {
  Eigen::Vector2d first, second;  // cycles per unit; |first| <= |second|, y >= 0, angle 60 to 120
  double explained = 0.0;         // share of the amplitude of all peaks that lies on the lattice
  int peaks_on_it = 0;
};

/// The coarsest lattice of frequencies that explains nearly as much of the peaks as any.
///
/// Candidates are spanned by pairs of strong peaks, and halves and thirds of them. The best is
/// refined by least squares over the peaks that lie on it.
///
/// resolution  width of a bin in cycles per unit along x and y: how far a peak may be off
/// throws      Error if there are fewer than two peaks that are not in one line
Lattice lattice_of(const std::vector<SpectralPeak>& peaks, const Eigen::Vector2d& resolution);

}  // namespace hada
