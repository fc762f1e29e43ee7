#pragma once

#include <algorithm>
#include <cstddef>

#include "reconstruct/pixel_level.h"
#include "reconstruct/row_kernels.h"

/// Where the kernels find half a row of a level, and what surrounds it.
namespace hada {

/// The four neighbours of the cells of half a row: all in runs, see `Dealt`.
template <class Result, class T>
Result neighbours(const Dealt& at, const T* values, const HalfRow& half) {
  const T* const here = values + at.start(half);
  const T* const beside = values + at.start({half.row, 1 - half.parity, half.first, half.count});
  return {here - at.stride(), here + at.stride(), half.parity == 0 ? beside - 1 : beside,
          half.parity == 0 ? beside : beside + 1};
}

inline row_kernels::Around values_around(const PixelLevel& level, const float* values,
                                         const HalfRow& half) {
  return neighbours<row_kernels::Around>(level.at, values, half);
}

inline row_kernels::AroundCodes codes_around(const PixelLevel& level, const HalfRow& half) {
  return neighbours<row_kernels::AroundCodes>(level.at, level.code.data(), half);
}

inline row_kernels::Around weights_around(const PixelLevel& level, const HalfRow& half) {
  const auto east = neighbours<row_kernels::Around>(level.at, level.east.data(), half);
  const float* const south = level.south.data() + level.at.start(half);
  return {south - level.at.stride(), south, east.left, level.east.data() + level.at.start(half)};
}

/// The blocks of a coarse row, which are cells of either half of its two fine rows.
inline PixelLevel::Stretch blocks_of(const PixelLevel& fine, const PixelLevel& coarse, int row) {
  const auto [first, last] = coarse.stretch(row);
  return {2 * first, std::min(2 * last, fine.at.block)};
}

/// The marks of even cells from a place on, or null.
inline const std::uint8_t* even_at(const PixelLevel& level, std::ptrdiff_t place) {
  return level.even.empty() ? nullptr : level.even.data() + place;
}

}  // namespace hada
