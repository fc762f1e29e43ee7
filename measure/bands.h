#pragma once

#include <vector>

#include "core/extent.h"
#include "core/grid.h"
#include "measure/spectrum.h"

namespace hada {

/// Waves of about one length and, where they have one, one direction: a hump of the spectrum.
struct Band {
  double wavelength = 0.0;  // inverse of the mean frequency, unit
  double direction = 0.0;   // of the mean wave vector, counter-clockwise from +x, radians, [0, pi)
  double anisotropy = 0.0;  // 0: all directions alike, 1: one direction only
  double rms = 0.0;         // unit
  double wavelength_sigma = 0.0;
  double direction_sigma = 0.0;
  double rms_sigma = 0.0;
};

struct BandOptions {
  double least_share = 1e-5;  // of the variance, for a band to be told
  int most = 8;
};

/// The bands of a map, the strongest first: the humps of its spectrum that its likelihood asks for,
/// and of each the waves that are there.
///
/// spectrum  of `map` inside `mask`, whose small holes are filled here as there (`small_holes.h`)
/// returns   wavelength, direction and rms of what is there, not of a law that it was drawn from;
///           sigma is how far that may lie from such a law
std::vector<Band> bands(const Spectrum& spectrum, const Grid<float>& map, const Mask& mask,
                        const BandOptions& options = {});

}  // namespace hada
