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

/// The cells that starts are ranked on, under the window as it is: the first fit, to a Gaussian
/// one, takes for floor or for noise functions what side lobes carry up a steep flank.
class StartCells {
 public:
  explicit StartCells(const Observation& seen);

  /// The cells, with the correction that makes the model exact for `wrinkle`.
  std::vector<Cell> exact_for(const Wrinkle<>& wrinkle) const;

  /// The deviance that `wrinkle` leaves on them.
  double cost(const Wrinkle<>& wrinkle) const;

  /// Whether they tell its floor from none; `cost_with` is that of `wrinkle`.
  bool tell_floor(const Wrinkle<>& wrinkle, double cost_with) const;

  /// `fit` moved to where they want it, if that costs less, and its cost.
  void settle(Fit<Wrinkle<>>& fit) const;

 private:
  const Observation& seen_;
  Grid<double> overlap_;
};

/// What a fit was refined on.
struct RefinedCells {
  std::vector<Cell> cells;
  const Spectrum* spectrum;  // that they are cut from, one of those that were observed
};

/// `fit` moved to where the whole spectrum and the exact window want it, and its uncertainty.
///
/// slow     of the spectrum and the levelling that were observed
RefinedCells refine(Fit<Wrinkle<>>& fit, const Observation& seen, const SlowWaves& slow);

/// Whether every component is known to be there: its amplitude is above its sigma.
bool all_told(const Fit<Wrinkle<>>& fit);

/// `best` refined, with intervals near bounds, or the largest of `fewer` that is told when refined:
/// what paid among the few cells that all starts look at may be nothing in the whole spectrum.
///
/// fewer  the best fit of each smaller number of components, in rising order
Fit<Wrinkle<>> refined_and_told(Fit<Wrinkle<>> best, std::vector<Fit<Wrinkle<>>> fewer,
                                const Observation& seen);

}  // namespace hada
