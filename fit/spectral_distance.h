#pragma once

#include <cmath>
#include <vector>

#include "fit/whittle.h"

namespace hada {

/// How far a model is from a cell, by the logarithm. Cells weigh as the square root of their
/// ordinates, so that the few slow waves, which hold most of the power, are heard beside the many
/// fast ones; those that are far off lose their say.
struct LogDistance {
  double independence;

  double weight(const Cell& cell) const {
    return std::sqrt(independence * std::sqrt(double(cell.count)));
  }
  template <class T>
  T operator()(const Cell& cell, const T& model) const {
    using std::log;
    constexpr double far_nepers = 2.0;  // 9 dB
    const double measured = std::log(cell.power) + bias_of_log_mean(cell.count);
    return weight(cell) * softened(T(measured - log(model)), far_nepers);
  }
};

/// The distances of all cells and, last, that of their whole power: what narrow peaks hold that no
/// model makes would else be missing, and a texture fainter than its picture looks like another.
inline CellResiduals<LogDistance> spectral_distances(const std::vector<Cell>& cells,
                                                     double independence) {
  const LogDistance distance{independence};
  double weights = 0.0;
  for (const Cell& cell : cells) weights += distance.weight(cell) * distance.weight(cell);
  constexpr double say_of_all = 0.05;  // of that of the cells
  return {cells, distance, std::sqrt(say_of_all * weights)};
}

}  // namespace hada
