#pragma once

#include <algorithm>
#include <cmath>

#include "core/grid.h"

namespace hada {

/// The logarithm of a brightness: minus what the wood absorbs, up to a constant.
inline Grid<float> absorbance(Grid<float> brightness) {
  constexpr float darkest = 0.01f;  // that still counts
  for (float& value : brightness) value = std::log(std::max(value, darkest));
  return brightness;
}

}  // namespace hada
