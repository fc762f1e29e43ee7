#pragma once

#include <vector>

#include "core/grid.h"
#include "fit/cells.h"
#include "measure/spectrum.h"
#include "synth/wrinkle.h"

namespace hada {

/// How much of the taper overlaps with itself when it is shifted: sum w(x) w(x + d) / sum w^2, lag
/// (i, j) at row i modulo 2 rows and column j modulo 2 cols; row lags run downward.
Grid<double> taper_overlap(const Grid<double>& taper);

/// The expected periodogram of `wrinkle` at every ordinate, its leakage included: the transform of
/// its autocovariance times the overlap of the taper, exact for any taper.
///
/// overlap  taper_overlap of a taper of the size of `extent`
Grid<double> expected_power(const Wrinkle<>& wrinkle, const Grid<double>& overlap,
                            const Extent& extent);

/// `cells` with the `correction` that makes the model exact for `wrinkle`: the mean of its expected
/// periodogram over the ordinates of a cell. A Gaussian window is none where peaks or flanks of the
/// spectrum are as narrow as the taper's or a cell.
std::vector<Cell> corrected(std::vector<Cell> cells, const Wrinkle<>& wrinkle,
                            const Grid<double>& overlap, const Extent& extent);

struct TrustOptions {
  double most_aliased = 0.005;   // share of a cell's power that aliases may add
  double most_leakage = 0.05;    // share that leakage may add
  double most_correction = 2.0;  // by the window, up or down, of the slowest ordinates
  double most_gained = 1.3;      // of others, which see side lobes and no wider peak
  double slow = 8.0;             // steps from 0 up to which ordinates are the slowest
  double faintest = 1e-9;        // share of the highest power below which rounding takes over
};

/// Those of `cells` that hold little but what `wrinkle` says of their own frequency.
///
/// The model is asked, not the measured power of the cell: to keep a cell because it happens to be
/// strong would make the spectrum look flatter than it is. A map of points, a map of pixel means
/// and a map that was made on its own grid repeat their spectrum beyond Nyquist in three different
/// ways; the bound on aliases holds for each.
std::vector<Cell> trusted(const std::vector<Cell>& cells, const Wrinkle<>& wrinkle,
                          const Extent& extent, const TrustOptions& options = {});

}  // namespace hada
