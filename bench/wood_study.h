#pragma once

#include <filesystem>
#include <optional>

#include "core/random.h"

namespace hada {

/// How well pith, rings and spiral of one rendered block were found.
struct BlockScore {
  double pith_mm = 0.0;     // distance from the true pith
  double radii_mm = 0.0;    // mean error of the rings that were found
  double recall = 0.0;      // share of the true rings that were found, within 0.4 mm
  double precision = 0.0;   // share of what was found that is a true ring
  double spiral_deg = 0.0;  // error of the angle
};

/// folder  of rendered/wood_block; name "softwood_a" or "ringporous_b"
BlockScore score_block(const std::filesystem::path& folder, const char* name);

/// Made stems of random pith, lobes and ring widths, looked at three times coarser than drawn, with
/// noise and 8 bits.
struct StemScore {
  double pith_share = 0.0;  // median over stems: error over the largest radius seen
  double radii_px = 0.0;    // root mean square error of the rings
  double f1 = 0.0;          // harmonic mean of recall and precision
  double coverage = 0.0;    // of 90 % intervals of pith, lobes and radii
  double pith_coverage = 0.0, lobe_coverage = 0.0, radii_coverage = 0.0;
  double spiral = 0.0;          // median error of the gradient of made faces
  double wave_amplitude = 0.0;  // median relative errors
  double wave_length = 0.0;
  double face_coverage = 0.0;  // of 90 % intervals of gradient, amplitude and length
  double gradient_coverage = 0.0, amplitude_coverage = 0.0, length_coverage = 0.0;
};

StemScore study_stems(int seeds);

/// Made faces of interlocked grain, evenly wide rings far from the pith, cut across them at an
/// angle.
struct InterlockScore {
  int faces = 0, told = 0;  // of these: told from straight and wavy grain
  double period = 0.0;      // median relative error
  double coverage = 0.0;    // of its 90 % intervals
};

InterlockScore study_interlock(int seeds);

/// Vessels of made end grains, diffuse-porous and ring-porous in turn, drawn twice finer, with
/// noise and 8 bits; medians of relative errors.
struct VesselScore {
  int woods = 0, right = 0;  // of these: porosity told right
  double density = 0.0, radius = 0.0;
  double coverage = 0.0;  // of 90 % intervals of both
};

VesselScore study_vessels(int seeds);

/// Seconds of one core for 2048 x 2048 pixels of wavy, ring-porous wood.
double seconds_of_a_slice();

}  // namespace hada
