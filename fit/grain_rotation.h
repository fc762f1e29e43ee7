#pragma once

#include "core/grid.h"
#include "fit/sequence_search.h"

namespace hada {

/// How well grain explains a picture at any angle of its rows.
///
/// The data are the periodogram of the picture as it lies. What is expected of each of its
/// ordinates is the transform of the autocovariance of the turned grain times the overlap of the
/// taper: exact at any angle.
///
/// Source: Sykulski et al., The debiased Whittle likelihood, Biometrika 106 (2019).
class GrainRotation {
 public:
  /// scores  grey values of mean 0
  explicit GrainRotation(const Grid<float>& scores);

  /// Logarithm of the likelihood if the rows of the block run up by `angle_rad`, counter-clockwise.
  double log_likelihood(const GrainModel& model, const GrainNuisance& nuisance,
                        double angle_rad) const;

 private:
  GrainSpectrum spectrum_;  // as it lies: its cells hold what does not turn
  Grid<double> power_;      // half of the periodogram
  double independence_;
};

/// An angle of the rows of a block, and by how many nats it explains a picture better than 0.
struct GrainAngle {
  double angle_rad = 0.0;
  double sigma_rad = 0.0;
  double gain = 0.0;
};

/// The likeliest angle near `start_rad`, by ever smaller steps.
GrainAngle likeliest_angle(const GrainRotation& rotation, const SequenceCandidate& grain,
                           double start_rad);

}  // namespace hada
