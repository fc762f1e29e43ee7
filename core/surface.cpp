#include "core/surface.h"

namespace hada {
namespace {

// The slope along one line of pixels: central where both neighbours count, else one-sided, else
// flat.
double slope(const Grid<float>& height, const Mask& mask, int row, int col, int d_row, int d_col) {
  const auto counts = [&](int r, int c) { return mask.contains(r, c) && mask(r, c); };
  const bool before = counts(row - d_row, col - d_col);
  const bool after = counts(row + d_row, col + d_col);
  const double here = height(row, col);
  if (before && after) {
    return 0.5 * (double(height(row + d_row, col + d_col)) - height(row - d_row, col - d_col));
  }
  if (after) return height(row + d_row, col + d_col) - here;
  if (before) return here - height(row - d_row, col - d_col);
  return 0.0;
}

}  // namespace

NormalMap normals_of(const Grid<float>& height, const Mask& mask, double pitch) {
  NormalMap normals(height.rows(), height.cols(), Eigen::Vector3f::UnitZ());
  for (int row = 0; row < height.rows(); ++row) {
    for (int col = 0; col < height.cols(); ++col) {
      if (!mask(row, col)) continue;
      const double dz_dx = slope(height, mask, row, col, 0, 1) / pitch;
      const double dz_dy = -slope(height, mask, row, col, 1, 0) / pitch;  // rows run against y
      normals(row, col) = Eigen::Vector3d(-dz_dx, -dz_dy, 1.0).normalized().cast<float>();
    }
  }
  return normals;
}

}  // namespace hada
