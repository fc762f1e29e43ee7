#pragma once

#include <array>
#include <vector>

#include "synth/wrinkle.h"

namespace hada {

struct RidgeStudyOptions {
  int maps = 40;
  int first = 0;  // which maps, for one machine after the other
  int size_px = 256;
  double pitch_mm = 0.2;
  double noise_mm = 0.001;  // white, on the height of each pixel
  double step_mm = 0.0005;  // to whole ones of which heights are rounded
};

/// The paper of map `seed`: two noise functions, skew, tail and sharpness, all drawn evenly.
Wrinkle<> ridge_truth(unsigned seed);

struct RidgeCase {
  std::array<double, 3> truth, found, sigma;  // skew, tail, sharpness
  double departure, left;                     // chi-square of six moments
  double seconds;                             // of the processor
};

/// Every map is cut from a larger sheet that is made at half the pitch.
std::vector<RidgeCase> study_ridges(const RidgeStudyOptions& options = {});

struct RidgeScore {
  double median_error, median_sigma;
  double coverage;  // share of maps whose 95 % interval holds the truth
  double spread;    // root mean square of the error in sigmas: 1 if sigma is right
  double bias;      // its mean
};

/// which  0 skew, 1 tail, 2 sharpness
RidgeScore score_of(const std::vector<RidgeCase>& cases, std::size_t which);

}  // namespace hada
