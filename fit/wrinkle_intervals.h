#pragma once

#include <vector>

#include "fit/cells.h"
#include "fit/fit.h"
#include "fit/slow_waves.h"
#include "measure/spectrum.h"
#include "synth/wrinkle.h"

namespace hada {

/// Where a floor would be seen that is none in the fit, and how independent their ordinates are.
struct FaintCells {
  std::vector<Cell> cells;
  double independence = 1.0;
};

/// The 95 % intervals, by profile likelihood, of the fields of `fit` that lie near a bound, where
/// +-1.96 sigma would not hold them.
///
/// Near its bound is what is not known to a twelfth of its value (an amplitude, a length or a floor
/// ends at 0), what ended on the bound, and both axes and the angle of a component whose axes
/// cannot be told apart: long >= short.
///
/// cells  that `fit` was refined on, of `spectrum`
/// slow   of that spectrum
/// faint  those that reach down to the lowest powers, under the window as it is
std::vector<FieldInterval> intervals_near_bounds(const Fit<Wrinkle<>>& fit,
                                                 const std::vector<Cell>& cells,
                                                 const Spectrum& spectrum, const SlowWaves& slow,
                                                 const FaintCells& faint);

}  // namespace hada
