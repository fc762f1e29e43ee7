#pragma once

#include "reconstruct/tile.h"

namespace hada {

/// Estimators that weigh each sample by its residual r and solve again, until nothing moves.
///
/// The scale s of a pixel is 1.4826 times the median of |r|, corrected for the three unknowns, and
/// at least `tile.floor`. Pixels with fewer than six samples have too little to judge by: there all
/// that may count do so alike.
///
/// Sources: P. J. Huber, Robust estimation of a location parameter (1964); P. W. Holland and R. E.
/// Welsch, Robust regression using iteratively reweighted least-squares (1977), for the constants
/// that keep 95 % of the efficiency under normal noise; A. E. Beaton and J. W. Tukey (1974).

/// w = min(1, 1.345 s / |r|)
void fit_huber(Tile& tile);
/// w = 1 / (1 + (r / 2.385 s)^2)
void fit_cauchy(Tile& tile);
/// w ~ 1 / |r|: the least sum of |r|
void fit_l1(Tile& tile);
/// w = (1 - (r / 4.685 s)^2)^2, 0 beyond, and 0 where the normal looks away from the light. Starts
/// from the samples between the ranks 0.2 and 0.8 of brightness, so that shadow and sheen are out
/// at once.
void fit_biweight(Tile& tile);
/// The same, from what `tile.x, y, z` hold.
void refit_biweight(Tile& tile);

}  // namespace hada
