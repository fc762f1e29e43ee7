#pragma once

#include "core/grid.h"

namespace hada {

/// Which way the lines of a picture run, and how clearly, pixel by pixel.
struct LineField {
  Grid<float> across;     // direction of strongest change, counter-clockwise from +x, [0, pi)
  Grid<float> coherence;  // 0: no direction, 1: all change is along one direction
  Grid<float> strength;   // root mean square gradient, per px; 0 where nothing is known
};

struct LineFieldOptions {
  double gradient_px =
      1.5;                 // Gaussian that the picture is smoothed by before its gradient is taken
  double window_px = 5.0;  // Gaussian over which gradients are gathered
};

/// The structure tensor of `map` inside `mask`; near the border of the mask nothing is known.
///
/// Source: Bigun and Granlund, ICCV 1987.
LineField line_field(const Grid<float>& map, const Mask& mask,
                     const LineFieldOptions& options = {});

/// `map` smoothed by a Gaussian inside `mask`, pixels outside not read; 0 where none is near.
Grid<float> smoothed(const Grid<float>& map, const Mask& mask, double sigma_px);

}  // namespace hada
