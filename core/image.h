#pragma once

#include <cstddef>
#include <vector>

#include "core/grid.h"

namespace hada {

/// A picture with linear values: one plane (grey) or three (red, green, blue), all of one size.
struct Image {
  std::vector<Grid<float>> planes;

  Image() = default;
  Image(int rows, int cols, int channels)
      : planes(std::size_t(channels), Grid<float>(rows, cols)) {}
  explicit Image(Grid<float> grey) { planes.push_back(std::move(grey)); }

  int rows() const { return planes.empty() ? 0 : planes.front().rows(); }
  int cols() const { return planes.empty() ? 0 : planes.front().cols(); }
  int channels() const { return int(planes.size()); }
  bool empty() const { return planes.empty(); }

  bool operator==(const Image&) const = default;
};

/// How much red, green and blue weigh in a grey value (Rec. ITU-R BT.709, linear light).
inline constexpr float luminance_weight[3] = {0.2126f, 0.7152f, 0.0722f};

/// One grey plane: the luminance of a colour picture, or a copy of a grey one.
Grid<float> luminance(const Image& image);

/// The pixels in the rectangle of `rows` x `cols` pixels whose first is (row, col), in every plane.
Image crop(const Image& image, int row, int col, int rows, int cols);

}  // namespace hada
