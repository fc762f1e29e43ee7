#pragma once

#include <cmath>

#include "core/grid.h"
#include "core/random.h"

namespace hada {

/// A map brought to mean 0 and variance 1, with white noise of this deviation.
inline Grid<float> noisy(Grid<float> map, double noise, Seed seed) {
  double sum = 0.0, squares = 0.0;
  for (const float value : map) {
    sum += value;
    squares += double(value) * value;
  }
  const auto n = double(map.size());
  const double deviation = std::sqrt(squares / n - sum * sum / (n * n));
  for (int row = 0; row < map.rows(); ++row) {
    for (int col = 0; col < map.cols(); ++col)
      map(row, col) =
          float((map(row, col) - sum / n) / deviation + noise * gaussian(seed, row, col));
  }
  return map;
}

}  // namespace hada
