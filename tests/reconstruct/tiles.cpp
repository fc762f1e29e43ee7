#include "tiles.h"

#include <Eigen/Dense>

namespace hada {

Eigen::Vector3d reference_fit(const Tile& tile, int pixel, const std::function<bool(int)>& counts) {
  Eigen::MatrixX3d directions = Eigen::MatrixX3d::Zero(tile.lights, 3);
  Eigen::VectorXd values = Eigen::VectorXd::Zero(tile.lights);
  for (int k = 0; k < tile.lights; ++k) {
    if (!counts(k)) continue;
    const auto i = std::size_t(k);
    directions.row(k) << tile.x_to[i], tile.y_to[i], tile.z_to[i];
    values[k] = tile.grey[tile.at(k, pixel)];
  }
  return directions.colPivHouseholderQr().solve(values);
}

std::vector<float> pseudo_inverse_of(const Tile& tile) {
  Eigen::MatrixX3d directions(tile.lights, 3);
  for (int k = 0; k < tile.lights; ++k) {
    const auto i = std::size_t(k);
    directions.row(k) << tile.x_to[i], tile.y_to[i], tile.z_to[i];
  }
  const Eigen::Matrix3d squares = directions.transpose() * directions;
  const Eigen::MatrixXd inverse = squares.inverse() * directions.transpose();
  std::vector<float> rows;
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < tile.lights; ++k) rows.push_back(float(inverse(axis, k)));
  }
  return rows;
}

}  // namespace hada
