#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

#include "core/memory.h"
#include "core/scratch_files.h"

namespace hada {

/// A rectangle of values addressed by (row, col), row 0 at the top, rows stored one after another.
template <class T>
class Grid {
 public:
  Grid() = default;
  /// where  absent: on the heap; else see `Memory`
  Grid(int rows, int cols, const T& value = T{}, std::pmr::memory_resource* where = nullptr)
      : rows_(rows), cols_(cols), values_(std::size_t(rows) * std::size_t(cols), value, where) {
    assert(rows >= 0 && cols >= 0);
  }

  int rows() const { return rows_; }
  int cols() const { return cols_; }
  std::size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }
  /// Where the values lie, for others that belong to them.
  std::pmr::memory_resource* memory() const { return values_.get_allocator().resource; }
  bool contains(int row, int col) const {
    return row >= 0 && row < rows_ && col >= 0 && col < cols_;
  }
  template <class U>
  bool same_size(const Grid<U>& other) const {
    return rows_ == other.rows() && cols_ == other.cols();
  }

  T& operator()(int row, int col) {
    assert(contains(row, col));
    return values_[std::size_t(row) * std::size_t(cols_) + std::size_t(col)];
  }
  const T& operator()(int row, int col) const {
    assert(contains(row, col));
    return values_[std::size_t(row) * std::size_t(cols_) + std::size_t(col)];
  }
  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }

  std::span<T> row(int row) {
    return {values_.data() + std::size_t(row) * std::size_t(cols_), std::size_t(cols_)};
  }
  std::span<const T> row(int row) const {
    return {values_.data() + std::size_t(row) * std::size_t(cols_), std::size_t(cols_)};
  }

  /// Of a grid in `scratch_files()`: the rows [begin, end) have been read or written and may leave
  /// the memory until they are wanted again. Nothing is lost, and nothing done for other grids.
  void let_go(int begin, int end) const {
    if (memory() != scratch_files()) return;
    let_go_of_memory(row(begin).data(), std::size_t(end - begin) * std::size_t(cols_) * sizeof(T));
  }
  void let_go() const { let_go(0, rows_); }

  T* data() { return values_.data(); }
  const T* data() const { return values_.data(); }
  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

  /// Keeps the first rows * cols values, where they are; the memory of the others is not given
  /// back.
  void shrink_to(int rows, int cols) {
    assert(rows >= 0 && cols >= 0);
    const std::size_t count = std::size_t(rows) * std::size_t(cols);
    assert(count <= values_.size());
    values_.erase(values_.begin() + std::ptrdiff_t(count), values_.end());
    rows_ = rows;
    cols_ = cols;
  }

  bool operator==(const Grid&) const = default;

 private:
  int rows_ = 0;
  int cols_ = 0;
  std::vector<T, Memory<T>> values_;
};

/// 1 where a pixel counts, 0 where it has no meaning and must not be read.
using Mask = Grid<std::uint8_t>;

/// The pixels of `grid` in the half-open rectangle of `rows` x `cols` pixels at (row, col);
/// none of an empty grid, which says that a surface has no such map.
template <class T>
Grid<T> crop(const Grid<T>& grid, int row, int col, int rows, int cols) {
  if (grid.empty()) return grid;
  assert(row >= 0 && col >= 0 && row + rows <= grid.rows() && col + cols <= grid.cols());
  // Any value: a vector of Eigen has no default one.
  Grid<T> part(rows, cols, grid[0], grid.memory());
  for (int r = 0; r < rows; ++r) {
    const auto source = grid.row(row + r).subspan(std::size_t(col), std::size_t(cols));
    std::copy(source.begin(), source.end(), part.row(r).begin());
  }
  return part;
}

}  // namespace hada
