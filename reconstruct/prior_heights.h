#pragma once

#include <string_view>

#include "core/grid.h"

namespace hada {

/// What a surface says of the levelling of a height whose long waves are of a prior.
inline constexpr std::string_view prior_levelling = "prior";

/// Heights of the same surface that are known from elsewhere: a coarse scan, or a few spots.
struct PriorHeights {
  Grid<float> height;      // on the pixels of the map, in its unit; NaN where nothing is known
  double cutoff_px = 0.0;  // wavelength in pixels, >= 4: longer waves are taken from here

  /// How a lattice of cells of `factor` x `factor` pixels sees a prior of 0: known where one of a
  /// cell's pixels is.
  PriorHeights zeros_of_cells(int factor) const;
};

/// Gives `height` the long waves of the prior and leaves it its own short ones.
///
/// What both differ by, where the prior is known, is smoothed and added: an offset for each region
/// of the mask, a plane that they share, and of the rest the part that a Gaussian filter lets
/// through, half of a wave of the cutoff. Far from all known pixels the rest fades to nothing.
/// At the end the mean of all pixels is 0 again.
///
/// height, mask  of the size of the prior; what lies outside the mask becomes 0
/// throws        Error if the prior knows no pixel of the mask
/// Source: areal Gaussian filter, ISO 16610-61; where pixels are missing, normalised convolution
/// (H. Knutsson, C.-F. Westin, CVPR 1993).
void level(Grid<float>& height, const Mask& mask, const PriorHeights& prior);

}  // namespace hada
