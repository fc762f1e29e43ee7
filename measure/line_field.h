#pragma once

#include "core/grid.h"

namespace hada {

/// Which way the lines of a picture run, and how clearly: the structure tensor of every pixel, all
/// of it 0 where nothing is known.
struct LineField {
  Grid<float> xx, xy, yy;  // means of products of the gradient, per px^2

  bool contains(int row, int col) const { return xx.contains(row, col); }
  /// Direction of strongest change, counter-clockwise from +x, [0, pi).
  float across(int row, int col) const;
  /// 0: no direction, 1: all change is along one direction.
  float coherence(int row, int col) const;
  /// Root mean square gradient, per px; 0 where nothing is known.
  float strength(int row, int col) const;
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
