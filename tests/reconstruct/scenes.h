#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "core/light_stack.h"
#include "core/random.h"
#include "core/surface.h"

/// Surfaces with a closed form and pictures of them, for the tests of this room.
namespace hada {

/// A height with its exact slopes, in px at pitch 1.
struct Relief {
  Extent extent;
  Grid<double> height;
  NormalMap normals;
};

/// `shape(x, y)` returns (z, dz/dx, dz/dy). Every pixel may lie elsewhere than its place in the
/// grid says, by `place_sigma` px along either axis.
template <class Shape>
Relief relief_of(int rows, int cols, const Shape& shape, double place_sigma = 0.0) {
  Relief relief{.extent = {.rows = rows, .cols = cols},
                .height = Grid<double>(rows, cols),
                .normals = NormalMap(rows, cols, Eigen::Vector3f::UnitZ())};
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const Eigen::Vector2d off(gaussian(17, row, col, 0), gaussian(17, row, col, 1));
      const Eigen::Vector2d place = relief.extent.place(row, col) + place_sigma * off;
      const Eigen::Vector3d z = shape(place.x(), place.y());
      relief.height(row, col) = z[0];
      relief.normals(row, col) = Eigen::Vector3d(-z[1], -z[2], 1.0).normalized().cast<float>();
    }
  }
  return relief;
}

inline Relief waves(int rows, int cols, double place_sigma = 0.0) {
  const auto shape = [](double x, double y) {
    return Eigen::Vector3d(2.0 * std::sin(0.2 * x) + 1.5 * std::cos(0.15 * y + 0.1 * x),
                           0.4 * std::cos(0.2 * x) - 0.15 * std::sin(0.15 * y + 0.1 * x),
                           -0.225 * std::sin(0.15 * y + 0.1 * x));
  };
  return relief_of(rows, cols, shape, place_sigma);
}

/// `count` lights around the sample, alternately 45 and 60 degrees above the table.
inline std::vector<Light> ring_of_lights(int count) {
  std::vector<Light> lights(std::size_t(count), Light{});
  for (int k = 0; k < count; ++k) {
    const double azimuth = 2.0 * std::numbers::pi * k / count;
    const double tilt = k % 2 == 0 ? 0.785 : 0.52;
    Light& light = lights[std::size_t(k)];
    light.image = "light " + std::to_string(k);
    light.direction = Eigen::Vector3d(std::sin(tilt) * std::cos(azimuth),
                                      std::sin(tilt) * std::sin(azimuth), std::cos(tilt));
  }
  return lights;
}

struct Matte {
  Eigen::Vector3d albedo = Eigen::Vector3d::Constant(0.6);
  int channels = 1;
  double noise = 0.0;  // standard deviation of one value
  Seed seed = 1;
};

/// Pictures of a matte relief, every sample without light marked as shadowed.
inline LightStack pictures_of(const Relief& relief, const std::vector<Light>& lights,
                              const Matte& matte = {}) {
  const auto& extent = relief.extent;
  LightStack stack;
  stack.camera.extent = extent;
  stack.lights = lights;
  stack.mask = full_mask(extent);
  for (std::size_t k = 0; k < lights.size(); ++k) {
    Image image(extent.rows, extent.cols, matte.channels);
    Grid<Sample> samples(extent.rows, extent.cols, Sample::lit);
    for (int row = 0; row < extent.rows; ++row) {
      for (int col = 0; col < extent.cols; ++col) {
        const Eigen::Vector2d place = extent.place(row, col);
        const Eigen::Vector3d normal = relief.normals(row, col).cast<double>().normalized();
        for (int channel = 0; channel < matte.channels; ++channel) {
          const double shading =
              normal.dot(arriving(lights[k], channel, Eigen::Vector3d(place.x(), place.y(), 0.0)));
          if (shading <= 0.0) samples(row, col) = Sample::shadowed;
          const auto key = std::int64_t(k) * 4 + channel;
          image.planes[std::size_t(channel)](row, col) =
              float(matte.albedo[channel] * std::max(0.0, shading) +
                    matte.noise * gaussian(matte.seed, row, col, key));
        }
      }
    }
    stack.images.push_back(std::move(image));
    stack.samples.push_back(std::move(samples));
  }
  return stack;
}

/// Root mean square of `a - b` after the mean of the difference is taken off, inside the mask.
template <class A, class B>
double rms_difference(const Grid<A>& a, const Grid<B>& b, const Mask& mask) {
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    const double difference = double(a[i]) - double(b[i]);
    count += 1.0;
    sum += difference;
    squares += difference * difference;
  }
  return std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count)));
}

/// A full rectangle from which single pixels, discs, slits and all but one pixel of some walls are
/// taken away, so that it has holes, narrow bridges and several regions.
inline Mask torn_mask(int rows, int cols, Seed seed) {
  Mask mask(rows, cols, 1);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      if (uniform(seed, row, col) < 0.03) mask(row, col) = 0;
      for (int hole = 0; hole < 6; ++hole) {
        const double y = row - uniform(seed, hole, -1) * rows;
        const double x = col - uniform(seed, hole, -2) * cols;
        if (std::hypot(x, y) < 0.08 * cols * uniform(seed, hole, -3)) mask(row, col) = 0;
      }
      for (int wall = 1; wall < 5; ++wall) {  // 1 or 2 px wide; the third has no bridge
        const bool in_wall = col == wall * cols / 5 || (wall == 2 && col == wall * cols / 5 + 1);
        const int bridge = int(uniform(seed, wall, -4) * rows);
        if (in_wall) mask(row, col) = wall != 3 && row == bridge;
      }
      if (row == rows / 3) mask(row, col) = col == cols / 2;
    }
  }
  return mask;
}

/// Shadows and highlights that nobody has marked, on a tenth of the samples.
inline LightStack spoiled(LightStack stack, Seed seed) {
  for (std::size_t k = 0; k < stack.images.size(); ++k) {
    for (std::size_t i = 0; i < stack.mask.size(); ++i) {
      const double luck = uniform(seed, std::int64_t(k), std::int64_t(i));
      float& value = stack.images[k].planes[0][i];
      if (luck < 0.05) value *= 0.1f;
      if (luck > 0.95) value += 0.5f;
    }
  }
  return stack;
}

}  // namespace hada
