#pragma once

#include <span>
#include <vector>

#include "core/memory.h"

namespace hada {

/// A sparse matrix, row by row. As a graph: what weighs the edges from every node to others; its
/// Laplacian has their sum on the diagonal and is not stored.
struct SparseRows {
  explicit SparseRows(int column_count = 0, std::pmr::memory_resource* where = nullptr)
      : columns(column_count), start(1, 0, where), column(where), weight(where) {}

  int rows() const { return int(start.size()) - 1; }
  std::pmr::memory_resource* memory() const { return start.get_allocator().resource; }

  std::span<const int> columns_of(int row) const {
    return {column.data() + begin(row), column.data() + begin(row + 1)};
  }
  std::span<const float> weights_of(int row) const {
    return {weight.data() + begin(row), weight.data() + begin(row + 1)};
  }

  /// Adds an entry to the last row, which `end_row` ends.
  void add(int to, float entry) {
    column.push_back(to);
    weight.push_back(entry);
  }
  void end_row() { start.push_back(int(column.size())); }

  int columns;
  std::vector<int, Memory<int>> start;  // of a row in the two below; the last is their end
  std::vector<int, Memory<int>> column;
  std::vector<float, Memory<float>> weight;

 private:
  std::ptrdiff_t begin(int row) const { return start[std::size_t(row)]; }
};

SparseRows transposed(const SparseRows& matrix);

}  // namespace hada
