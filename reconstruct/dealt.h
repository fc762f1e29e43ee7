#pragma once

#include <cstddef>

namespace hada {

/// Cells side by side in one block of a row of `Dealt`.
struct HalfRow {
  int row;
  int parity;  // of its columns
  int first;   // of the cells that are meant, in their block
  int count;
};

/// How the rows of a grid lie in memory: first the cells of its even columns, then those of its odd
/// ones, each block padded.
///
/// On a chessboard every cell then has its four neighbours in the other block of its own row and in
/// the same block of the rows above and below, each as an unbroken run: half a row of one colour is
/// updated by a plain loop over arrays, which every compiler turns into vector instructions.
/// Padding and one guard row above and below stay 0, so no loop asks whether a neighbour exists.
struct Dealt {
  /// Blocks and stretches are whole runs of so many cells: kernels ask whether as many are alike,
  /// and take half of a stretch, of coarser cells, in eights.
  static constexpr int together = 16;

  int rows = 0;
  int cols = 0;
  int half = 0;   // columns of even index
  int block = 0;  // cells of a block with its padding, at least half + 1

  Dealt() = default;
  Dealt(int row_count, int col_count)
      : rows(row_count),
        cols(col_count),
        half((cols + 1) / 2),
        block((half + together) / together * together) {}

  std::size_t size() const { return (std::size_t(rows) + 2) * stride(); }
  std::ptrdiff_t stride() const { return 2 * std::ptrdiff_t(block); }
  /// The first cell of the even (0) or odd (1) columns of a row; rows -1 and `rows` are guards.
  std::ptrdiff_t start(int row, int parity) const { return (row + 1) * stride() + parity * block; }
  std::ptrdiff_t start(const HalfRow& cells) const {
    return start(cells.row, cells.parity) + cells.first;
  }
  std::ptrdiff_t cell(int row, int col) const { return start(row, col % 2) + col / 2; }
};

}  // namespace hada
