#pragma once

#include <string>
#include <vector>

#include "synth/wrinkle.h"

namespace hada {

struct WrinkleStudyOptions {
  int seeds = 40;
  int size_px = 512;      // of the map that is fitted, along each side
  double pitch_mm = 0.2;  // of that map
  int components = 0;     // how many the fit is told of; 0: it chooses
  double noise_mm = 0.0;  // standard deviation of white height noise
};

/// How well one fitted field of one component found its truth, over the seeds of a study.
struct FieldScore {
  std::string path;           // "components[0].amplitude_mm"
  double median_error = 0.0;  // relative; of an angle in degrees
  double median_sigma = 0.0;  // the same of what the Fisher information says
  double coverage = 0.0;      // share of 95 % intervals that hold the truth
  double bias = 0.0;          // mean error over sigma, 0 +- 1 / sqrt(seeds) if there is none
  double spread = 0.0;        // root mean square of error over sigma, 1 if sigma is honest
};

struct WrinkleScore {
  std::vector<FieldScore> fields;
  double coverage = 0.0;         // over all fields
  double right_count = 0.0;      // share of seeds with the true number of components
  double seconds_median = 0.0;   // of a fit
  std::vector<double> goodness;  // p of every seed
  std::vector<double> agreeing;  // share of starts that ended at the best
};

/// Three noise functions with kernels of about 16, 5 and 1.7 pixels; axes, directions and
/// amplitudes vary with the seed.
Wrinkle<> study_truth(unsigned seed, double pitch_mm);

/// Fits maps whose wrinkles are known.
///
/// Each map is cut from a field twice as wide and sampled twice as finely, so that it neither tiles
/// nor shares its grid of frequencies with the fit.
WrinkleScore study_wrinkles(const WrinkleStudyOptions& options = {});

/// Share of `maps` maps, of 1 to 4 noise functions whose lengths differ by factors of 2 or more,
/// whose number the fit finds.
double study_component_count(int maps);

/// Processor seconds on one thread, medians of `runs`.
double wrinkle_fit_seconds(int runs);             // 512 x 512 pixels, three components
double synthesis_seconds(int side_px, int runs);  // three components, normals included

}  // namespace hada
