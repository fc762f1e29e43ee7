#pragma once

#include "core/bounding_box.h"
#include "core/extent.h"
#include "core/grid.h"

namespace hada {

/// The tapered two-dimensional power spectrum of a map, in physical units.
struct Spectrum {
  Grid<double> power;  // unit^4 (mm^2 per (cycle/mm)^2), rows x cols, frequency 0 at (0, 0)
  Extent extent;       // of the part of the map that was measured: the bounding box of its mask
  Grid<double> taper;  // the weight w of every pixel of that part, 0 to 1
  /// What part of a periodogram ordinate is independent of its neighbours:
  /// (sum w^2)^2 / (N sum w^4), 1 without a taper.
  double independence = 1.0;
  /// How fast the autocorrelation of the taper falls along x and y: exp(-(window_x dx^2 + ...)),
  /// in 1/unit^2, matched at zero lag. The argument of `psd` that makes a model comparable.
  double window_x = 0.0;
  double window_y = 0.0;

  /// Frequency in cycles per unit of the ordinate at (row, col); y up.
  double fx(int col) const;
  double fy(int row) const;
};

constexpr int fewest_spectrum_pixels = 8;  // along each side

struct SpectrumOptions {
  double taper = 0.25;  // share of each side that a Tukey window falls off over, 0 to 1
};

/// The periodogram of `map` inside `mask`, its weighted mean taken off first.
///
/// Small holes of the mask are filled first (`small_holes.h`), and count as map. The taper is the
/// product of a Tukey window over the bounding box of the mask and, for a mask with an irregular
/// border or holes, of a smooth fall-off towards its edge. Normalised so that the sum of the power
/// over all frequencies, divided by the area, is the variance of the map.
///
/// throws  Error if the mask is empty or smaller than 8 x 8 pixels
Spectrum power_spectrum(const Grid<float>& map, const Mask& mask, const Extent& extent,
                        const SpectrumOptions& options = {});

/// taper (map - mean) in `box`, the mean weighted so that nothing is left at frequency 0; 0, and
/// the map not read, where the taper is 0.
Grid<double> tapered(const Grid<float>& map, const PixelBox& box, const Grid<double>& taper);

}  // namespace hada
