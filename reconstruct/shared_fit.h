#pragma once

#include <vector>

#include "reconstruct/shared_terms.h"

namespace hada {

/// Which shared terms are looked for.
struct SharedModel {
  bool curve = false;
  bool bounce = false;
  std::vector<double> light_sigma;  // of each light: how far off it may be, over its strength
};

struct SharedFit {
  SharedTerms terms;
  double misfit = 0.0;   // mean square left over, in units of the variance of the pixels
  double freedom = 0.0;  // samples that counted less the unknowns of the pixels
};

/// The terms that make the samples of a tile fit best once each pixel has taken its own three
/// unknowns: least squares with the weights of the tile, the unknowns of the pixels eliminated.
///
/// Errors of the lights are always among the terms, held by their sigma: they are shared by all
/// pixels as well, and would pass for a curve or for bounced light if they were not.
///
/// tile  x, y, z and weight as an estimator left them; raw, and bounce if that is asked for
SharedFit fit_shared_terms(const Tile& tile, const SharedModel& model);

}  // namespace hada
