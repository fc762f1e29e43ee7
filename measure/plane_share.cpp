#include "measure/plane_share.h"

#include <algorithm>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace hada {

double plane_share(const Grid<float>& height, const Mask& mask) {
  double mean = 0.0, count = 0.0;
  for (std::size_t i = 0; i < height.size(); ++i) {
    if (!mask[i]) continue;
    mean += height[i];
    count += 1.0;
  }
  mean /= std::max(count, 1.0);
  // By least squares on (1, x, y): moments of z with the terms, and of the terms with each other.
  Eigen::Matrix3d terms = Eigen::Matrix3d::Zero();
  Eigen::Vector3d with_z = Eigen::Vector3d::Zero();
  double squares = 0.0;
  for (int row = 0; row < height.rows(); ++row) {
    for (int col = 0; col < height.cols(); ++col) {
      if (!mask(row, col)) continue;
      const Eigen::Vector3d at(1.0, 2.0 * (col + 0.5) / height.cols() - 1.0,
                               2.0 * (row + 0.5) / height.rows() - 1.0);
      const double z = height(row, col) - mean;
      terms += at * at.transpose();
      with_z += z * at;
      squares += z * z;
    }
  }
  constexpr double rounding = 1e-7;  // of a float
  if (squares <= rounding * rounding * mean * mean * count) return 0.0;
  return with_z.dot(terms.ldlt().solve(with_z)) / squares;
}

}  // namespace hada
