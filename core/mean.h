#pragma once

#include <cassert>
#include <cstddef>

#include "core/grid.h"

namespace hada {

/// The mean of the values inside the mask; 0 where there are none.
inline double mean(const Grid<float>& values, const Mask& mask) {
  assert(values.same_size(mask));
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!mask[i]) continue;
    sum += double(values[i]);
    ++count;
  }
  return count > 0 ? sum / double(count) : 0.0;
}

}  // namespace hada
