#pragma once

#include <vector>

#include "core/surface.h"
#include "synth/wrinkle.h"

namespace hada {

struct ClassifyOptions {
  double amplitude_spread = 0.1;  // sheets of one kind differ: deviation of the log of heights
  double length_spread = 0.1;     // and of the log of lengths
};

/// How well a kind of sheet explains a measured one.
struct Likeness {
  double probability = 0.0;  // among the kinds asked for, all alike before looking
  double amplitude = 1.0;    // heights of the sheet over those of the kind
  double length = 1.0;       // lengths, likewise
  double turn_rad = 0.0;     // how far the sheet lies turned, counter-clockwise, in (-pi/2, pi/2]
  double goodness_p = 0.0;   // small: this is no sheet of the kind
};

/// How like each of `kinds` the wrinkles of `surface` are, in the order of the kinds.
///
/// Every kind may be turned, and stretched in height and length as far as sheets of one kind
/// differ; a white floor takes up the noise. Probabilities are Laplace's approximation of the
/// evidence under the Whittle likelihood, tempered where even the best kind leaves more than
/// chance.
///
/// kinds    at least one, in the unit of the surface
/// throws   Error if the surface has nothing to look at, see `observe`
///
/// Source: Kiso et al., section 4 (what tells papers apart); Tierney and Kadane, JASA 81 (1986).
std::vector<Likeness> classify(const Surface& surface, const std::vector<Wrinkle<>>& kinds,
                               const ClassifyOptions& options = {});

}  // namespace hada
