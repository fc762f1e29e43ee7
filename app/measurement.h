#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/surface.h"
#include "measure/bands.h"
#include "measure/decay.h"
#include "measure/histogram.h"
#include "measure/polar.h"
#include "measure/roughness.h"
#include "measure/spectrum.h"
#include "synth/material.h"

namespace hada {

/// Everything that is said of a surface before any model is believed.
struct Measurement {
  std::string quantity;  // "height", or "brightness" where there is no height
  Extent extent;
  RoughnessEstimate roughness;
  Spectrum spectrum;
  Rings rings;
  Sectors sectors;
  std::optional<Decay> decay;  // of the rings
  std::vector<Band> bands;
  Histogram values;                 // of the quantity, 4 Sq about its mean
  std::optional<Histogram> slopes;  // of the steepness of a height, up to 4 Sdq
  std::vector<int> ring_peaks;
  std::vector<int> sector_peaks;
};

Measurement measure(const Surface& surface);

/// What a number of a roughness is counted in: "mm", "rad", "per mm^2" or nothing.
std::string unit_of(const RoughnessField& field, Unit unit);

/// The text of measure.json.
std::string measurement_text(const Measurement& measurement);

/// The JSON object of a roughness, as in measure.json; null for what is not known.
std::string roughness_text(const Roughness& roughness);

/// What the spectrum of `like` would be expected to be if its surface were made of `material`:
/// the same lattice, the same taper. Empty for a material that has no spectrum of its own.
Spectrum expected_spectrum(const Material& material, const Spectrum& like);

}  // namespace hada
