#pragma once

#include <cstddef>

#include "core/light_stack.h"

namespace hada {

/// A grey value with the light's strength divided out of each channel.
///
/// decode  what becomes of a stored value first
template <class Decode>
float equalized(const Image& image, const Light& light, std::size_t pixel, const Decode& decode) {
  if (image.channels() < 3) return float(decode(image.planes[0][pixel]) / light.strength[0]);
  float grey = 0.0f;
  for (int c = 0; c < 3; ++c) {
    const float value = decode(image.planes[std::size_t(c)][pixel]);
    grey += luminance_weight[c] * float(value / light.strength[c]);
  }
  return grey;
}

inline float equalized(const Image& image, const Light& light, std::size_t pixel) {
  return equalized(image, light, pixel, [](float value) { return value; });
}

}  // namespace hada
