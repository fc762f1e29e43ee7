#include "measure/plane_share.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "core/mean.h"

namespace hada {

double plane_share(const Grid<float>& height, const Mask& mask) {
  const double level = mean(height, mask);
  // By least squares on (1, x, y): moments of z with the terms, and of the terms with each other.
  Eigen::Matrix3d terms = Eigen::Matrix3d::Zero();
  Eigen::Vector3d with_z = Eigen::Vector3d::Zero();
  double squares = 0.0;
  for (int row = 0; row < height.rows(); ++row) {
    for (int col = 0; col < height.cols(); ++col) {
      if (!mask(row, col)) continue;
      const Eigen::Vector3d at(1.0, 2.0 * (col + 0.5) / height.cols() - 1.0,
                               2.0 * (row + 0.5) / height.rows() - 1.0);
      const double z = height(row, col) - level;
      terms += at * at.transpose();
      with_z += z * at;
      squares += z * z;
    }
  }
  constexpr double rounding = 1e-7;  // of a float
  if (squares <= rounding * rounding * level * level * terms(0, 0)) return 0.0;
  return with_z.dot(terms.ldlt().solve(with_z)) / squares;
}

}  // namespace hada
