#pragma once

#include <vector>

#include "fit/fit.h"
#include "fit/observe.h"
#include "fit/slow_waves.h"
#include "synth/wrinkle.h"

namespace hada {

/// The last fields of a wrinkle: what its spectrum does not know.
constexpr int ridge_fields = 3;

/// How many fields the spectrum knows: all but the ridges.
int spectral_fields(const Wrinkle<>& wrinkle);

/// `fit` moved to where the whole spectrum and the exact window want it, and its uncertainty.
///
/// slow     of the spectrum and the levelling that were observed
/// returns  the cells that it was refined on
std::vector<Cell> refine(Fit<Wrinkle<>>& fit, const Observation& seen, const SlowWaves& slow);

/// Whether every component is known to be there: its amplitude is above its sigma.
bool all_told(const Fit<Wrinkle<>>& fit);

/// `best` refined, with intervals near bounds, or the largest of `fewer` that is told when refined:
/// what paid among the few cells that all starts look at may be nothing in the whole spectrum.
///
/// fewer  the best fit of each smaller number of components, in rising order
Fit<Wrinkle<>> refined_and_told(Fit<Wrinkle<>> best, std::vector<Fit<Wrinkle<>>> fewer,
                                const Observation& seen);

}  // namespace hada
