#pragma once

#include "core/grid.h"

namespace hada {

/// The comb of grey values that a quantised picture shows, in units of `grey`.
struct GreyLevels {
  double step = 0.0;     // between neighbouring levels; 0 where no comb is seen
  double highest = 0.0;  // level above the lowest possible one
  double step_sigma = 0.0;
  double highest_sigma = 0.0;
};

/// Levels and step from the histogram: the step is the period at which the characteristic function
/// of the grey values has a line, the highest level the last tooth of that comb.
///
/// The block's extremes have the grey values 0 and highest. Where the lowest tooth of an untouched
/// comb stands at 0 the picture holds them, and the last tooth is the highest. Else they lie
/// elsewhere: the highest is then told by the symmetry of the heights and by their spread, which a
/// block of the paper's size exceeds about tenfold, to 8 % and so that it stands on a tooth.
/// folds  number of folds of the grain
/// grey  0 to 255, as the picture is stored
GreyLevels grey_levels(const Grid<float>& grey, int folds);

}  // namespace hada
