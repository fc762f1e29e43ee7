#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "reconstruct/tile.h"

#ifdef __SSE__
#include <xmmintrin.h>
#endif

/// Eight neighbouring pixels at a time, for the sources that are compiled for more than one
/// machine.
///
/// A lane never looks at another, and no operation is contracted or reordered, so a pixel gets the
/// same bytes on every machine and wherever it lies. Everything here is inlined: no `Lanes` crosses
/// a call. No Eigen in sources that include this.
namespace hada {

using Lanes = float __attribute__((vector_size(32)));
using LaneBits = std::int32_t __attribute__((vector_size(32)));  // all ones: yes
using LaneBytes = std::uint8_t __attribute__((vector_size(32)));

[[gnu::always_inline]] inline Lanes load(const float* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

[[gnu::always_inline]] inline void store(float* to, const Lanes& lanes) {
  std::memcpy(to, &lanes, sizeof lanes);
}

/// As `store`, past the caches: memory that is only written need not be read first. `finish_stores`
/// must follow before another thread looks.
///
/// to  a multiple of 32 bytes
[[gnu::always_inline]] inline void store_past_caches(float* to, const Lanes& lanes) {
#ifdef __SSE__  // in halves: what every processor of the kind can do
  float halves[lane_count];
  std::memcpy(halves, &lanes, sizeof lanes);
  _mm_stream_ps(to, _mm_loadu_ps(halves));
  _mm_stream_ps(to + lane_count / 2, _mm_loadu_ps(halves + lane_count / 2));
#else
  store(to, lanes);
#endif
}

[[gnu::always_inline]] inline void finish_stores() {
#ifdef __SSE__
  _mm_sfence();
#endif
}

/// Yes where a byte is not 0.
///
/// Each lane gets four bytes and looks at its own: GCC would widen bytes one by one.
[[gnu::always_inline]] inline LaneBits load_flags(const std::uint8_t* from) {
  std::int32_t parts[2];
  std::memcpy(parts, from, sizeof parts);
  LaneBits lanes{};
  lanes[0] = parts[0];
  lanes[1] = parts[1];
  constexpr auto last = std::int32_t(0xff000000u);
  const LaneBits own{0xff, 0xff00, 0xff0000, last, 0xff, 0xff00, 0xff0000, last};
  return (__builtin_shufflevector(lanes, lanes, 0, 0, 0, 0, 1, 1, 1, 1) & own) != 0;
}

/// 1 for yes, 0 for no.
[[gnu::always_inline]] inline void store_flags(std::uint8_t* to, const LaneBits& which) {
  const LaneBits ones = which & 1;
  LaneBytes bytes;
  std::memcpy(&bytes, &ones, sizeof bytes);
  const LaneBytes lowest =
      __builtin_shufflevector(bytes, bytes, 0, 4, 8, 12, 16, 20, 24, 28, 0, 0, 0, 0, 0, 0, 0, 0, 0,
                              0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
  std::memcpy(to, &lowest, lane_count);
}

// A shuffle, which GCC makes one instruction of after inlining; a list of eight values it takes
// apart before, when it does not know yet what the machine can do.
[[gnu::always_inline]] inline Lanes all(float value) {
  Lanes lanes{};
  lanes[0] = value;
  return __builtin_shufflevector(lanes, lanes, 0, 0, 0, 0, 0, 0, 0, 0);
}

[[gnu::always_inline]] inline Lanes chosen(const LaneBits& which, const Lanes& yes,
                                           const Lanes& no) {
  return which ? yes : no;
}

[[gnu::always_inline]] inline Lanes larger(const Lanes& a, const Lanes& b) {
  return chosen(a > b, a, b);
}

[[gnu::always_inline]] inline Lanes smaller(const Lanes& a, const Lanes& b) {
  return chosen(a < b, a, b);
}

[[gnu::always_inline]] inline Lanes magnitude(const Lanes& a) {
  return larger(a, -a);
}

[[gnu::always_inline]] inline Lanes root(const Lanes& a) {
  Lanes result;
  for (int i = 0; i < lane_count; ++i) result[i] = std::sqrt(a[i]);
  return result;
}

[[gnu::always_inline]] inline bool any(const LaneBits& bits) {
  std::uint64_t parts[4];
  std::memcpy(parts, &bits, sizeof parts);
  return (parts[0] | parts[1] | parts[2] | parts[3]) != 0;
}

}  // namespace hada
