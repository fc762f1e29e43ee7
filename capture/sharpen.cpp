#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "capture/matte_sphere.h"
#include "capture/sphere_geometry.h"
#include "core/parallel.h"

namespace hada {
namespace {

struct RimPixel {
  int row, col;
  double background_u, background_v;  // where the table beside it is seen
};

// Pixels on both sides of the rim, thinned to about three thousand.
std::vector<RimPixel> rim_pixels(const Extent& extent, const Sphere& sphere, double reach) {
  const double inner = 0.85 * sphere.radius_px;
  const double outer = sphere.radius_px + reach;
  const double beside = sphere.radius_px + reach + 2.5;
  std::vector<RimPixel> pixels;
  for (int row = int(sphere.center_px.y() - outer); row <= int(sphere.center_px.y() + outer);
       ++row) {
    for (int col = int(sphere.center_px.x() - outer); col <= int(sphere.center_px.x() + outer);
         ++col) {
      const Eigen::Vector2d way = Eigen::Vector2d(col + 0.5, row + 0.5) - sphere.center_px;
      const double distance = way.norm();
      if (distance < inner || distance > outer) continue;
      const Eigen::Vector2d beside_px = sphere.center_px + beside / distance * way;
      const bool inside = row >= 0 && col >= 0 && row < extent.rows && col < extent.cols &&
                          beside_px.x() >= 0.0 && beside_px.y() >= 0.0 &&
                          beside_px.x() < extent.cols && beside_px.y() < extent.rows;
      if (inside) pixels.push_back({row, col, beside_px.x(), beside_px.y()});
    }
  }
  const std::size_t stride = pixels.size() / 3000 + 1;
  std::vector<RimPixel> thinned;
  for (std::size_t i = 0; i < pixels.size(); i += stride) thinned.push_back(pixels[i]);
  return thinned;
}

// What a pixel on the rim would show: the shaded sphere where it covers the pixel, the table else.
double drawn(const RimPixel& pixel, double background, const MatteShading& shading,
             const SphereInSpace& sphere, const Camera& camera, const Sphere& seen) {
  constexpr int fine = 8;
  const Eigen::Vector2d at(pixel.col + 0.5, pixel.row + 0.5);
  const bool on_rim = std::abs((at - seen.center_px).norm() - seen.radius_px) < 1.5;
  const int steps = on_rim ? fine : 1;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const auto normal =
          sphere.normal_at(camera, pixel.col + (i + 0.5) / steps, pixel.row + (j + 0.5) / steps);
      sum += normal ? std::max(0.0, normal->dot(shading.b)) + shading.ambient : background;
    }
  }
  return sum / (steps * steps);
}

}  // namespace

Sphere sharpened_matte(const Photographs& linear, const Sphere& sphere, double reach) {
  const Camera& camera = linear.camera;
  const auto pixels = rim_pixels(camera.extent, sphere, reach);
  const std::size_t pictures = linear.images.size();
  std::vector<Grid<float>> greys(pictures);
  for (std::size_t k = 0; k < pictures; ++k) greys[k] = luminance(linear.images[k]);

  // Residuals of one picture, in units of its own brightness.
  const auto residuals_of = [&](std::size_t k, const Sphere& seen) {
    const MatteShading shading = matte_shading(greys[k], linear.saturated[k], camera, seen, 0.9);
    const SphereInSpace in_place = in_space(seen, camera);
    const double scale = 1.0 / std::max(shading.b.norm(), 1e-12);
    std::vector<double> residuals;
    residuals.reserve(pixels.size());
    for (const RimPixel& pixel : pixels) {
      const double background = greys[k](int(pixel.background_v), int(pixel.background_u));
      const double model = drawn(pixel, background, shading, in_place, camera, seen);
      const bool known = !linear.saturated[k](pixel.row, pixel.col);
      residuals.push_back(known ? scale * (greys[k](pixel.row, pixel.col) - model) : 0.0);
    }
    return residuals;
  };
  const auto moved = [](Sphere seen, const Eigen::Vector3d& by) {
    seen.center_px += by.head<2>();
    seen.radius_px += by[2];
    return seen;
  };

  Sphere best = sphere;
  for (int round = 0; round < 5; ++round) {
    std::vector<Eigen::Matrix3d> normals(pictures, Eigen::Matrix3d::Zero());
    std::vector<Eigen::Vector3d> rights(pictures, Eigen::Vector3d::Zero());
    std::vector<double> squares(pictures, 0.0);
    for_each_index(int(pictures), [&](int picture) {
      const auto k = std::size_t(picture);
      // Central differences: one-sided ones pulled every centre by half a step.
      constexpr double step = 0.15;  // px
      const auto here = residuals_of(k, best);
      std::vector<std::vector<double>> before(3), after(3);
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d by = step * Eigen::Vector3d::Unit(axis);
        before[std::size_t(axis)] = residuals_of(k, moved(best, -by));
        after[std::size_t(axis)] = residuals_of(k, moved(best, by));
      }
      constexpr double huber = 0.03;  // of the brightness: dust, contact shadow, mirrored sheet
      for (std::size_t i = 0; i < here.size(); ++i) {
        Eigen::Vector3d jacobian;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          jacobian[Eigen::Index(axis)] = (after[axis][i] - before[axis][i]) / (2.0 * step);
        }
        const double weight = std::min(1.0, huber / std::max(std::abs(here[i]), 1e-12));
        normals[k] += weight * jacobian * jacobian.transpose();
        rights[k] -= weight * here[i] * jacobian;
        squares[k] += weight * here[i] * here[i];
      }
    });
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double total = 0.0;
    for (std::size_t k = 0; k < pictures; ++k) {
      normal += normals[k];
      right += rights[k];
      total += squares[k];
    }
    normal.diagonal().array() += 1e-9;
    Eigen::Vector3d step = normal.ldlt().solve(right);
    if (step.norm() > 0.5) step *= 0.5 / step.norm();
    const Sphere next = moved(best, step);
    const bool near = (next.center_px - sphere.center_px).norm() < reach &&
                      std::abs(next.radius_px - sphere.radius_px) < reach;
    if (!near || !step.allFinite()) return sphere;
    best = next;
    // Neighbouring residuals hang together over a few pixels and all pictures share the outline.
    constexpr double clumping = 8.0;
    const double variance = total / double(pictures * pixels.size());
    best.sigma_px = std::sqrt(clumping * double(pictures) * variance * normal.inverse()(0, 0));
    if (step.norm() < 2e-3) break;
  }
  // A stand or a contact shadow can pull the rim away: the disc itself must agree with the move.
  const auto misfit = [&](const Sphere& seen) {
    double sum = 0.0;
    for (std::size_t k = 0; k < pictures; ++k) {
      sum += matte_shading(greys[k], linear.saturated[k], camera, seen).misfit;
    }
    return sum;
  };
  return misfit(best) <= misfit(sphere) ? best : sphere;
}

}  // namespace hada
