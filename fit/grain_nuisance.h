#pragma once

#include "fit/grain_model.h"

namespace hada {

/// What is known of scale and aspect: that a pixel is a place, or no more than that it is about
/// one.
///
/// Then the logarithms of both are normal beforehand, about 0.
enum class GrainScale { one, about_one };
constexpr double log_scale_sigma = 0.15;
constexpr double log_aspect_sigma = 0.05;

/// How well a sequence explains a periodogram, with the nuisance that suits it best.
struct GrainFit {
  GrainNuisance nuisance;
  double cost = 0.0;  // half the deviance of the Whittle likelihood
  /// Nats that the likelihood of all scales, weighed by what is known beforehand, falls short of
  /// that of the best one; 0 where the scale is known.
  double occam = 0.0;
};

/// The nuisance with the least deviance (and, of an unknown scale, the most probable one), by
/// bounded descent from `start`; `model` is left at its scale.
///
/// A known scale stays that of the start.
GrainFit fit_nuisance(GrainModel& model, const GrainSpectrum& spectrum, const GrainNuisance& start,
                      int most_iterations, GrainScale scale = GrainScale::one);

}  // namespace hada
