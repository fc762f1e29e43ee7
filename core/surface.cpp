#include "core/surface.h"

#include <cmath>

#include "core/parallel.h"

namespace hada {
namespace {

// The slope along one line of pixels: central where both neighbours count, else one-sided, else
// flat.
float slope(const Grid<float>& height, const Mask& mask, int row, int col, int d_row, int d_col) {
  const auto counts = [&](int r, int c) { return mask.contains(r, c) && mask(r, c); };
  const bool before = counts(row - d_row, col - d_col);
  const bool after = counts(row + d_row, col + d_col);
  const float here = height(row, col);
  if (before && after) {
    return 0.5f * (height(row + d_row, col + d_col) - height(row - d_row, col - d_col));
  }
  if (after) return height(row + d_row, col + d_col) - here;
  if (before) return here - height(row - d_row, col - d_col);
  return 0.0f;
}

Eigen::Vector3f normal(float dz_dx, float dz_dy) {
  const float scale = 1.0f / std::sqrt(1.0f + dz_dx * dz_dx + dz_dy * dz_dy);
  return {-dz_dx * scale, -dz_dy * scale, scale};
}

}  // namespace

NormalMap normals_of(const Grid<float>& height, const Mask& mask, double pitch) {
  NormalMap normals(height.rows(), height.cols(), Eigen::Vector3f::UnitZ());
  const float per_pixel = float(1.0 / pitch);
  for_each_index(height.rows(), [&](int row) {
    const bool inner_row = row > 0 && row + 1 < height.rows();
    for (int col = 0; col < height.cols(); ++col) {
      if (!mask(row, col)) continue;
      float right, down;  // the steps of the height
      if (inner_row && col > 0 && col + 1 < height.cols() &&
          (mask(row, col - 1) & mask(row, col + 1) & mask(row - 1, col) & mask(row + 1, col))) {
        right = 0.5f * (height(row, col + 1) - height(row, col - 1));
        down = 0.5f * (height(row + 1, col) - height(row - 1, col));
      } else {
        right = slope(height, mask, row, col, 0, 1);
        down = slope(height, mask, row, col, 1, 0);
      }
      normals(row, col) = normal(right * per_pixel, -down * per_pixel);  // rows run against y
    }
  });
  return normals;
}

}  // namespace hada
