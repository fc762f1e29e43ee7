#include "capture/relief.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"

namespace hada {
namespace {

constexpr int block = 16;         // cells along a side of a block
constexpr double grazing = 1e-6;  // how far, in pitches, a relief may rise above its own cells by
                                  // rounding

// The largest slope, in height per cell, of the bilinear surface in one block.
float steepest_in(const Grid<float>& height, int block_row, int block_col) {
  const int last_row = std::min((block_row + 1) * block, height.rows() - 1);
  const int last_col = std::min((block_col + 1) * block, height.cols() - 1);
  float down = 0.0f;
  float right = 0.0f;
  for (int row = block_row * block; row <= last_row; ++row) {
    for (int col = block_col * block; col <= last_col; ++col) {
      if (row < last_row) down = std::max(down, std::abs(height(row + 1, col) - height(row, col)));
      if (col < last_col) {
        right = std::max(right, std::abs(height(row, col + 1) - height(row, col)));
      }
    }
  }
  return std::hypot(down, right);
}

// The largest value of each cell and the eight around it.
Grid<float> largest_around(const Grid<float>& values) {
  Grid<float> largest = values;
  for (int row = 0; row < values.rows(); ++row) {
    for (int col = 0; col < values.cols(); ++col) {
      for (int r = row - 1; r <= row + 1; ++r) {
        for (int c = col - 1; c <= col + 1; ++c) {
          if (values.contains(r, c)) largest(row, col) = std::max(largest(row, col), values(r, c));
        }
      }
    }
  }
  return largest;
}

}  // namespace

Relief::Relief(Grid<float> height, double pitch) : height_(std::move(height)), pitch_(pitch) {
  for (const float value : height_) top_ = std::max(top_, double(value));
  Grid<float> own((height_.rows() + block - 1) / block, (height_.cols() + block - 1) / block);
  for_each_index(own.rows(), [&](int row) {
    for (int col = 0; col < own.cols(); ++col) own(row, col) = steepest_in(height_, row, col);
  });
  steepest_ = largest_around(own);
}

double Relief::height_at(double row, double col) const {
  const int r = int(row);
  const int c = int(col);
  const double down = row - r;
  const double right = col - c;
  return (1.0 - down) * ((1.0 - right) * height_(r, c) + right * height_(r, c + 1)) +
         down * ((1.0 - right) * height_(r + 1, c) + right * height_(r + 1, c + 1));
}

// Follows the ray to the light cell by cell. Where the relief around it is nowhere steeper than the
// ray, the gap between them cannot close, and the length of a block is passed in one step.
bool Relief::hides(const Eigen::Vector2d& pixel, double z, const Eigen::Vector3d& to_light) const {
  const double level = to_light.head<2>().norm();
  if (level < 1e-6) return false;
  const double rise = pitch_ * to_light.z() / level;  // per cell along the ground
  const double d_row = -to_light.y() / level;
  const double d_col = to_light.x() / level;
  double row = pixel.x();
  double col = pixel.y();
  while (z < top_) {
    if (row < 0.0 || col < 0.0 || row >= height_.rows() - 1 || col >= height_.cols() - 1) break;
    const bool gentle = steepest_(int(row) / block, int(col) / block) <= rise;
    if (!gentle && height_at(row, col) > z + grazing * pitch_) return true;
    const double step = gentle ? block : 1.0;
    row += step * d_row;
    col += step * d_col;
    z += step * rise;
  }
  return false;
}

}  // namespace hada
