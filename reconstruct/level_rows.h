#pragma once

#include <cstddef>

#include "reconstruct/pixel_level.h"
#include "reconstruct/row_kernels.h"

/// Where the kernels find half a row of a level, and what surrounds it.
namespace hada {

/// The four neighbours of the cells of (row, parity): all in runs, see `Dealt`.
template <class Result, class T>
Result neighbours(const Dealt& at, const T* values, int row, int parity) {
  const T* const beside = values + at.start(row, 1 - parity);
  return {values + at.start(row - 1, parity), values + at.start(row + 1, parity),
          parity == 0 ? beside - 1 : beside, parity == 0 ? beside : beside + 1};
}

inline row_kernels::Around values_around(const PixelLevel& level, const float* values, int row,
                                         int parity) {
  return neighbours<row_kernels::Around>(level.at, values, row, parity);
}

inline row_kernels::AroundCodes codes_around(const PixelLevel& level, int row, int parity) {
  return neighbours<row_kernels::AroundCodes>(level.at, level.code.data(), row, parity);
}

inline row_kernels::Around weights_around(const PixelLevel& level, int row, int parity) {
  const Dealt& at = level.at;
  const float* const east = level.east.data();
  const float* const south = level.south.data();
  return {south + at.start(row - 1, parity), south + at.start(row, parity),
          parity == 0 ? east + at.start(row, 1) - 1 : east + at.start(row, 0),
          east + at.start(row, parity)};
}

/// The marks of even cells from a place on, or null.
inline const std::uint8_t* even_at(const PixelLevel& level, std::ptrdiff_t place) {
  return level.even.empty() ? nullptr : level.even.data() + place;
}

}  // namespace hada
