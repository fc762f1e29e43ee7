#pragma once

#include <algorithm>

#include "core/grid.h"

namespace hada {

/// The picture at image point (u, v), between its four nearest pixel centres; the border goes on.
inline double bilinear(const Grid<float>& picture, double u, double v) {
  const double x = std::clamp(u - 0.5, 0.0, picture.cols() - 1.0);
  const double y = std::clamp(v - 0.5, 0.0, picture.rows() - 1.0);
  const int col = int(x);
  const int row = int(y);
  const int right = std::min(col + 1, picture.cols() - 1);
  const int below = std::min(row + 1, picture.rows() - 1);
  const double fx = x - col;
  const double fy = y - row;
  return (1.0 - fy) * ((1.0 - fx) * picture(row, col) + fx * picture(row, right)) +
         fy * ((1.0 - fx) * picture(below, col) + fx * picture(below, right));
}

}  // namespace hada
