#pragma once

#include "core/grid.h"

/// The parts that a map is divided into where one is left out at a time: 4 x 4 rectangles.
namespace hada {

inline constexpr int blocks_per_side = 4;
inline constexpr int block_count = blocks_per_side * blocks_per_side;

template <class T>
int block_row(const Grid<T>& map, int row) {
  return int(long(row) * blocks_per_side / map.rows());
}

template <class T>
int block_col(const Grid<T>& map, int col) {
  return int(long(col) * blocks_per_side / map.cols());
}

template <class T>
int block_at(const Grid<T>& map, int row, int col) {
  return block_row(map, row) * blocks_per_side + block_col(map, col);
}

/// Whether a block holds enough of the mask to be left out alone: a tenth of an average one.
inline bool counts_as_block(double pixels, double all_pixels) {
  return pixels >= 0.1 * all_pixels / block_count && pixels < all_pixels;
}

}  // namespace hada
