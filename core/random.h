#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace hada {

/// What a random field is made from. The same seed gives the same numbers on every machine.
using Seed = std::uint64_t;

/// One more part of a key mixed into the bits of those before it.
///
/// Source: the finaliser of SplitMix64 (Steele, Lea, Flood, OOPSLA 2014) chained over the key.
inline std::uint64_t mixed(std::uint64_t state, std::int64_t part) {
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;
  state += golden + std::uint64_t(part) * 0xd1342543de82ef95u;
  state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9u;
  state = (state ^ (state >> 27)) * 0x94d049bb133111ebu;
  return state ^ (state >> 31);
}

/// 64 well-mixed bits of a key: a pure function, so nothing depends on the order of evaluation.
inline std::uint64_t hash(Seed seed, std::int64_t i, std::int64_t j = 0, std::int64_t k = 0) {
  return mixed(mixed(mixed(seed, i), j), k);
}

/// A number in the open interval (0, 1) made of mixed bits.
inline double unit_interval(std::uint64_t bits) {
  return (double(bits >> 11) + 0.5) * 0x1p-53;
}

/// A number in the open interval (0, 1), uniform.
inline double uniform(Seed seed, std::int64_t i, std::int64_t j = 0, std::int64_t k = 0) {
  return unit_interval(hash(seed, i, j, k));
}

/// A number with mean 0 and variance 1, Gaussian (Box and Muller 1958).
inline double gaussian(Seed seed, std::int64_t i, std::int64_t j = 0, std::int64_t k = 0) {
  const double radius = std::sqrt(-2.0 * std::log(uniform(seed, i, j, 2 * k)));
  return radius * std::cos(2.0 * std::numbers::pi * uniform(seed, i, j, 2 * k + 1));
}

}  // namespace hada
