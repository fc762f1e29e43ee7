#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/grid.h"

namespace hada {

/// A picture with linear values: one plane (grey) or three (red, green, blue), all of one size.
struct Image {
  std::vector<Grid<float>> planes;

  Image() = default;
  Image(int rows, int cols, int channels, std::pmr::memory_resource* memory = nullptr) {
    for (int c = 0; c < channels; ++c) planes.emplace_back(rows, cols, 0.0f, memory);
  }
  explicit Image(Grid<float> grey) { planes.push_back(std::move(grey)); }

  int rows() const { return planes.empty() ? 0 : planes.front().rows(); }
  int cols() const { return planes.empty() ? 0 : planes.front().cols(); }
  int channels() const { return int(planes.size()); }
  bool empty() const { return planes.empty(); }

  std::pmr::memory_resource* memory() const {
    return planes.empty() ? nullptr : planes.front().memory();
  }
  /// See Grid.
  void let_go(int begin, int end) const {
    for (const auto& plane : planes) plane.let_go(begin, end);
  }
  void let_go() const { let_go(0, rows()); }

  bool operator==(const Image&) const = default;
};

/// How much red, green and blue weigh in a grey value (Rec. ITU-R BT.709, linear light).
inline constexpr std::array<float, 3> luminance_weight = {0.2126f, 0.7152f, 0.0722f};

/// One grey plane: the luminance of a colour picture, or its planes weighed otherwise; a copy of a
/// grey one. It is kept where the picture is; on disk, neither stays in memory.
Grid<float> luminance(const Image& image, const std::array<float, 3>& weight = luminance_weight);

/// The same of one row.
void luminance(const Image& image, int row, std::span<float> grey,
               const std::array<float, 3>& weight = luminance_weight);

/// Calls `read(begin, end)` for one band of rows after the other, so low that a band of many large
/// pictures takes little memory; after each, the caller lets go of it.
template <class Read>
void for_each_band(int first, int last, const Read& read) {
  constexpr int band_rows = 64;
  for (int row = first; row < last; row += band_rows) read(row, std::min(last, row + band_rows));
}

/// The pixels in the rectangle of `rows` x `cols` pixels whose first is (row, col), in every plane.
Image crop(const Image& image, int row, int col, int rows, int cols);

}  // namespace hada
