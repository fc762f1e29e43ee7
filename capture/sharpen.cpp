#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
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
  double turn;                        // around the sphere: 0 to 1
};

// Pixels on both sides of the rim, thinned to about three thousand.
std::vector<RimPixel> rim_pixels(const Extent& extent, const Sphere& sphere, double reach) {
  const double inner = std::min(0.85 * sphere.radius_px, sphere.radius_px - 4.0);
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
      const double turn = std::atan2(way.y(), way.x()) / (2.0 * std::numbers::pi) + 0.5;
      if (inside) pixels.push_back({row, col, beside_px.x(), beside_px.y(), turn});
    }
  }
  const std::size_t stride = pixels.size() / 3000 + 1;
  std::vector<RimPixel> thinned;
  for (std::size_t i = 0; i < pixels.size(); i += stride) thinned.push_back(pixels[i]);
  return thinned;
}

// What a pixel on the rim would show: the shaded sphere where it covers the pixel, the table else.
struct Drawn {
  double value = 0.0;
  double covered = 0.0;  // the share of the pixel that is sphere
};

Drawn drawn(const RimPixel& pixel, double background, const MatteShading& shading,
            const SphereInSpace& sphere, const Camera& camera, const Sphere& seen) {
  constexpr int fine = 8;
  const Eigen::Vector2d at(pixel.col + 0.5, pixel.row + 0.5);
  const bool on_rim = std::abs((at - seen.center_px).norm() - seen.radius_px) < 1.5;
  const int steps = on_rim ? fine : 1;
  const double share = 1.0 / (steps * steps);
  Drawn sum;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const auto normal =
          sphere.normal_at(camera, pixel.col + (i + 0.5) / steps, pixel.row + (j + 0.5) / steps);
      const double lit = normal ? std::max(0.0, normal->dot(shading.b)) + shading.ambient : 0.0;
      sum.value += share * (normal ? lit : background);
      sum.covered += normal ? share : 0.0;
    }
  }
  return sum;
}

constexpr int sectors = 24;

// What the sphere just within its rim shows beyond what is drawn, in every sector: a + b n_z. No
// real sphere is shaded like a Lambert one there, and what it lacks would move the outline: by
// 1.6 px of 108 on a polished stone ball. So only the step at the rim places it.
using Excess = std::array<Eigen::Vector2d, sectors>;

// The basis (1, n_z) at a pixel, n_z as on the nearest place of the sphere.
Eigen::Vector2d basis_at(const RimPixel& pixel, const Sphere& seen) {
  const Eigen::Vector2d at(pixel.col + 0.5, pixel.row + 0.5);
  const double r = std::min(1.0, (at - seen.center_px).norm() / seen.radius_px);
  return {1.0, std::sqrt(1.0 - r * r)};
}

Excess excess_of(const std::vector<RimPixel>& pixels, const std::vector<double>& differences,
                 const Sphere& seen) {
  constexpr double widest = 8.0;   // px within the rim
  constexpr double nearest = 2.5;  // px: what lies closer may show the table, too
  std::array<Eigen::Matrix2d, sectors> normals;
  Excess rights;
  normals.fill(1e-9 * Eigen::Matrix2d::Identity());
  rights.fill(Eigen::Vector2d::Zero());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Eigen::Vector2d at(pixels[i].col + 0.5, pixels[i].row + 0.5);
    const double depth = seen.radius_px - (at - seen.center_px).norm();
    if (depth < nearest || depth > widest || std::isnan(differences[i])) continue;
    const auto sector = std::size_t(std::min(sectors - 1, int(sectors * pixels[i].turn)));
    const Eigen::Vector2d basis = basis_at(pixels[i], seen);
    normals[sector] += basis * basis.transpose();
    rights[sector] += differences[i] * basis;
  }
  Excess excess;
  for (std::size_t s = 0; s < excess.size(); ++s) excess[s] = normals[s].ldlt().solve(rights[s]);
  return excess;
}

// Linear between the middles of the sectors.
double excess_at(const Excess& excess, const RimPixel& pixel, const Sphere& seen) {
  const double place = pixel.turn * sectors - 0.5 + sectors;
  const auto before = std::size_t(place) % sectors;
  const double share = place - std::floor(place);
  return basis_at(pixel, seen)
      .dot((1.0 - share) * excess[before] + share * excess[(before + 1) % sectors]);
}

}  // namespace

Sphere sharpened_matte(const Photographs& linear, const Sphere& sphere, double reach) {
  const Camera& camera = linear.camera;
  const auto pixels = rim_pixels(camera.extent, sphere, reach);
  const std::size_t pictures = linear.images.size();
  std::vector<Grid<float>> greys(pictures);
  for (std::size_t k = 0; k < pictures; ++k) greys[k] = luminance(linear.images[k]);

  // Residuals of one picture, in units of its own brightness; 0 where it says nothing.
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto residuals_of = [&](std::size_t k, const Sphere& seen) {
    const MatteShading shading = matte_shading(greys[k], linear.saturated[k], camera, seen, 0.9);
    const SphereInSpace in_place = in_space(seen, camera);
    const double scale = 1.0 / std::max(shading.b.norm(), 1e-12);
    std::vector<double> residuals;
    std::vector<double> covered;
    for (const RimPixel& pixel : pixels) {
      const double background = greys[k](int(pixel.background_v), int(pixel.background_u));
      const Drawn model = drawn(pixel, background, shading, in_place, camera, seen);
      const bool known = !linear.saturated[k](pixel.row, pixel.col);
      residuals.push_back(known ? scale * (greys[k](pixel.row, pixel.col) - model.value) : nan);
      covered.push_back(model.covered);
    }
    const Excess excess = excess_of(pixels, residuals, seen);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      residuals[i] -= covered[i] * excess_at(excess, pixels[i], seen);
      if (std::isnan(residuals[i])) residuals[i] = 0.0;
    }
    return residuals;
  };
  const auto moved = [](Sphere seen, const Eigen::Vector3d& by) {
    seen.center_px += by.head<2>();
    seen.radius_px += by[2];
    return seen;
  };

  Sphere best = sphere;
  for (int round = 0; round < 8; ++round) {
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
  // A stand or a contact shadow can pull the rim away: the disc itself must agree with the move. It
  // need not become more like a Lambert one: it gains a little wherever it takes in what it lacks.
  constexpr double no_worse = 1.1;
  const auto misfit = [&](const Sphere& seen) {
    double sum = 0.0;
    for (std::size_t k = 0; k < pictures; ++k) {
      sum += matte_shading(greys[k], linear.saturated[k], camera, seen).misfit;
    }
    return sum;
  };
  return misfit(best) <= no_worse * misfit(sphere) ? best : sphere;
}

}  // namespace hada
