#pragma once

#include <vector>

#include "reconstruct/tile.h"
#include "scenes.h"

/// Tiles with a known answer, for the tests of what is computed eight pixels at a time.
namespace hada {

inline constexpr double tile_rho = 0.6;

/// A normal that differs from pixel to pixel, within 20 degrees of the axis.
inline Eigen::Vector3d tile_normal(int pixel) {
  return Eigen::Vector3d(0.35 * uniform(11, pixel) - 0.17, 0.35 * uniform(12, pixel) - 0.17, 1.0)
      .normalized();
}

/// What `pixels` matte pixels of albedo `tile_rho` show under distant lights, all to be trusted.
inline Tile matte_tile(const std::vector<Light>& lights, int pixels) {
  Tile tile(int(lights.size()), pixels, false);
  for (int k = 0; k < tile.lights; ++k) {
    const Eigen::Vector3d direction = lights[std::size_t(k)].direction.normalized();
    tile.x_to[std::size_t(k)] = float(direction.x());
    tile.y_to[std::size_t(k)] = float(direction.y());
    tile.z_to[std::size_t(k)] = float(direction.z());
    for (int i = 0; i < pixels; ++i) {
      tile.grey[tile.at(k, i)] = float(tile_rho * tile_normal(i).dot(direction));
      tile.trust[tile.at(k, i)] = 1.0f;
    }
  }
  return tile;
}

/// What least squares in double precision finds from the samples that `counts(light)` names.
template <class Counts>
Eigen::Vector3d reference_fit(const Tile& tile, int pixel, const Counts& counts) {
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

/// (N^T N)^-1 N^T of the directions of the tile: three rows.
inline std::vector<float> pseudo_inverse_of(const Tile& tile) {
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

inline Eigen::Vector3d found_in(const Tile& tile, int pixel) {
  const auto i = std::size_t(pixel);
  return {tile.x[i], tile.y[i], tile.z[i]};
}

}  // namespace hada
