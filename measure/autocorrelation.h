#pragma once

#include <optional>
#include <vector>

#include "core/grid.h"

namespace hada {

/// The autocorrelation of a map inside its mask, about its mean: products of pairs over their
/// number and over the variance, 1 at lag 0, at lags of at most half of each side.
class Autocorrelation {
 public:
  /// height  not read outside `mask`, and not constant inside it
  Autocorrelation(const Grid<float>& height, const Mask& mask);

  /// The value at a lag in pixels (right, down), bilinear between whole lags; empty where fewer
  /// than a quarter of the pixels have a partner.
  std::optional<double> at(double right, double down) const;

  /// The first lag (px) along a direction (right, down) at which it has fallen to 0.2, the value of
  /// ISO 25178-3; the last lag that can be believed where it never does.
  double length_px(double right, double down) const;

  /// `length_px` in every direction of half a turn, in equal steps counter-clockwise from +x.
  std::vector<double> lengths_px(int directions) const;

 private:
  std::optional<double> at_lag(int row, int col) const;
  double pairs(int row, int col) const;

  int most_rows_;
  int most_cols_;
  int rows_, cols_;
  double fewest_pairs_ = 0.0;
  Grid<float> products_;
  Grid<float> pairs_;  // of a mask that leaves nothing out: none, they are known
};

}  // namespace hada
