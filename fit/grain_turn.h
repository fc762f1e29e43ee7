#pragma once

#include "core/grid.h"

namespace hada {

constexpr double turned_band = 0.41;  // cycles per px up to which turning keeps all power

struct MirrorOptions {
  double most_rad = 0.21;    // 12 degrees: how far the axis may lie from the rows of the picture
  double step_rad = 0.0044;  // a quarter of a degree
};

/// The angle, counter-clockwise from the rows of a picture, of the axis about which its spectrum is
/// most like its own mirror image, in rad.
///
/// Folds stretch along two axes at right angles, so that both are mirrors of the spectrum of
/// grain, whatever its sequence.
/// scores  grey values of mean 0
double mirror_axis(const Grid<float>& scores, const MirrorOptions& options = {});

/// The middle of a picture whose rows run at `angle_rad` (counter-clockwise, below 45 degrees),
/// turned back until they lie level: the largest part that sees no rim. Empty if there is none.
///
/// Three shears, each by a long windowed sinc: frequencies up to `turned_band` along both axes keep
/// their power, and white noise remains white among them.
///
/// Source: Unser, Thevenaz and Yaroslavsky, Convolution-based interpolation for fast, high-quality
/// rotation of images, IEEE Transactions on Image Processing 4 (1995).
Grid<float> turned_back(const Grid<float>& picture, double angle_rad);

}  // namespace hada
