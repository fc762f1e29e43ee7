#pragma once

#include <functional>
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
Eigen::Vector3d reference_fit(const Tile& tile, int pixel, const std::function<bool(int)>& counts);

/// (N^T N)^-1 N^T of the directions of the tile: three rows.
std::vector<float> pseudo_inverse_of(const Tile& tile);

inline Eigen::Vector3d found_in(const Tile& tile, int pixel) {
  const auto i = std::size_t(pixel);
  return {tile.x[i], tile.y[i], tile.z[i]};
}

}  // namespace hada
