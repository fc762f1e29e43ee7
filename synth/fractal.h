#pragma once

#include <cmath>
#include <cstdint>

#include "core/random.h"

namespace hada {

/// A value between -1 and 1 for a point of a lattice: one round of what `hash` chains, because
/// pictures ask for hundreds of millions.
inline double lattice_value(Seed seed, std::int64_t i, std::int64_t j) {
  std::uint64_t state =
      seed + std::uint64_t(i) * 0x9e3779b97f4a7c15u + std::uint64_t(j) * 0xd1342543de82ef95u;
  state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9u;
  state = (state ^ (state >> 27)) * 0x94d049bb133111ebu;
  return double(std::int64_t(state ^ (state >> 31))) * 0x1p-63;
}

/// A smooth random function of two coordinates: values between -1 and 1, one to a lattice point,
/// joined by the quintic curve of Perlin (SIGGRAPH 2002), so that slopes are continuous.
inline double value_noise(Seed seed, double x, double y) {
  const double left = std::floor(x), below = std::floor(y);
  const auto i = std::int64_t(left), j = std::int64_t(below);
  const auto eased = [](double t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); };
  const double u = eased(x - left), v = eased(y - below);
  const auto at = [&](std::int64_t a, std::int64_t b) { return lattice_value(seed, a, b); };
  const double low = at(i, j) + u * (at(i + 1, j) - at(i, j));
  const double high = at(i, j + 1) + u * (at(i + 1, j + 1) - at(i, j + 1));
  return low + v * (high - low);
}

/// A sum of three octaves of `value_noise`, each half as large and half as wide as the one before,
/// between -1 and 1.
inline double fractal_noise(Seed seed, double x, double y) {
  double sum = 0.0, size = 4.0 / 7.0;
  for (int octave = 0; octave < 3; ++octave, size *= 0.5, x *= 2.0, y *= 2.0)
    sum += size * value_noise(seed + Seed(octave), x, y);
  return sum;
}

}  // namespace hada
