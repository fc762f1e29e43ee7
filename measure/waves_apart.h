#pragma once

#include <optional>
#include <vector>

#include "core/extent.h"
#include "core/grid.h"
#include "measure/hump_mixture.h"

namespace hada {

/// The waves of one hump.
struct Waves {
  double mean_square = 0.0;  // over the pixels of the mask, all alike, unit^2
  Grid<float> map;           // unit, in the steps of `WavesApart::extent`
  /// Mean frequency of the hump over what is to be expected of `map`, which is weaker where other
  /// humps lie.
  double frequency_ratio = 1.0;
};

/// A map taken apart into waves.
struct WavesApart {
  /// Of every hump; none where its waves are shorter than 8 of some 128 steps over the map, for
  /// which a taper costs little.
  std::vector<std::optional<Waves>> of_hump;
  Extent extent;  // of their maps
  Mask mask;
  Grid<float> rest;  // the map without these waves, as fine as it was
};

/// Takes a map apart into the waves of the humps of its spectrum, without a taper: each is what a
/// Gaussian field with the spectrum of the hump most probably is, given the sum of all on the mask.
/// So waves that the map holds only a few of are measured up to its border.
///
/// Source: Wiener's filter on a domain with a border (Rasmussen and Williams, *Gaussian processes
/// for machine learning*, 2006, section 2.2), solved by conjugate gradients with the covariance as
/// a product of transforms (Dietrich and Newsam, SIAM Journal on Scientific Computing 18, 1997).
WavesApart waves_apart(const Grid<float>& map, const Mask& mask, const Extent& extent,
                       const HumpMixture& mixture);

}  // namespace hada
