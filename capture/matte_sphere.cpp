#include "capture/matte_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <Eigen/Dense>

#include "capture/sphere_geometry.h"
#include "core/parallel.h"
#include "core/quantile.h"

namespace hada {
namespace {

struct DiscPoint {
  Eigen::Vector3d normal;
  double value;
  int block;  // 0 to 15: eight sectors, inner and outer half of the area
};

constexpr int blocks = 16;

int block_of(const Eigen::Vector2d& from_center, double radius_px) {
  const double turn = std::atan2(from_center.y(), from_center.x()) / (2.0 * std::numbers::pi) + 0.5;
  const int sector = std::min(7, int(8.0 * turn));
  return 2 * sector + (from_center.squaredNorm() > 0.5 * radius_px * radius_px ? 1 : 0);
}

// The unsaturated pixels of the disc, thinned to about six thousand.
std::vector<DiscPoint> disc_points(const Grid<float>& grey, const Mask& saturated,
                                   const Camera& camera, const Sphere& sphere, double rim) {
  const SphereInSpace in_place = in_space(sphere, camera);
  const double reach = rim * sphere.radius_px;
  const int stride = std::max(1, int(std::sqrt(3.1416 * reach * reach / 6000.0)));
  std::vector<DiscPoint> points;
  const int first_row = std::max(0, int(sphere.center_px.y() - reach));
  const int first_col = std::max(0, int(sphere.center_px.x() - reach));
  const int last_row = std::min(grey.rows() - 1, int(sphere.center_px.y() + reach));
  const int last_col = std::min(grey.cols() - 1, int(sphere.center_px.x() + reach));
  for (int row = first_row; row <= last_row; row += stride) {
    for (int col = first_col; col <= last_col; col += stride) {
      const Eigen::Vector2d from_center = Eigen::Vector2d(col + 0.5, row + 0.5) - sphere.center_px;
      if (from_center.norm() > reach || saturated(row, col)) continue;
      const auto normal = in_place.normal_at(camera, col + 0.5, row + 0.5);
      if (!normal) continue;
      points.push_back({*normal, grey(row, col), block_of(from_center, sphere.radius_px)});
    }
  }
  return points;
}

// What the side shows that the light does not reach, if there is enough of it.
std::optional<double> dark_side(const Eigen::Vector3d& b, const std::vector<DiscPoint>& points) {
  std::vector<double> dark;
  const double turned_away = -0.1 * b.norm();
  for (const DiscPoint& point : points) {
    if (point.normal.dot(b) < turned_away) dark.push_back(point.value);
  }
  constexpr std::size_t enough = 30;
  if (dark.size() < enough) return std::nullopt;
  return median(std::move(dark));
}

// The ambient light is what the dark side shows; where all is lit, none.
//
// Left free, it would be bent by whatever is not Lambertian on the lit side: without this the
// lights of a slightly glossy sphere were off by up to 9 degrees.
double ambient_of(const Eigen::Vector3d& b, const std::vector<DiscPoint>& points) {
  return std::max(0.0, dark_side(b, points).value_or(0.0));
}

// One weighted step on the clipped cosine; Tukey's weights at a width of `width` (infinite: none).
void improve(MatteShading& shading, const std::vector<DiscPoint>& points, double width,
             int without_block) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const DiscPoint& point : points) {
    const double lit = point.normal.dot(shading.b);
    if (point.block == without_block || lit <= 0.0) continue;
    const double residual = point.value - lit - shading.ambient;
    const double t = residual / width;
    if (std::abs(t) >= 1.0) continue;
    const double weight = (1.0 - t * t) * (1.0 - t * t);
    normal += weight * point.normal * point.normal.transpose();
    right += weight * residual * point.normal;
  }
  normal.diagonal().array() += 1e-12 * normal.trace() + 1e-300;
  shading.b += normal.ldlt().solve(right);
  shading.ambient = ambient_of(shading.b, points);
}

// A width for Tukey's weights: 4.685 robust standard deviations of the residuals.
double tukey_width(const MatteShading& shading, const std::vector<DiscPoint>& points) {
  std::vector<double> sizes;
  sizes.reserve(points.size());
  for (const DiscPoint& point : points) {
    const double lit = std::max(0.0, point.normal.dot(shading.b));
    sizes.push_back(std::abs(point.value - lit - shading.ambient));
  }
  return std::max(4.685 * 1.4826 * median(std::move(sizes)), 1e-3 * shading.b.norm() + 1e-12);
}

MatteShading shading_of(const std::vector<DiscPoint>& points) {
  MatteShading shading;
  if (points.size() < 30) return shading;
  double sum = 0.0;
  for (const DiscPoint& point : points) sum += point.value;
  const double mean = sum / double(points.size());
  double squares = 0.0;
  for (const DiscPoint& point : points) squares += (point.value - mean) * (point.value - mean);
  const double deviation = std::sqrt(squares / double(points.size()));
  constexpr double even = 1e-6;
  if (!(deviation > even * std::abs(mean))) return shading;
  // The start: the mean normal weighted by brightness points roughly at the light.
  for (const DiscPoint& point : points) shading.b += point.value * point.normal;
  shading.b *= 2.0 * mean / std::max(shading.b.norm(), 1e-300);
  for (int round = 0; round < 6; ++round) {
    improve(shading, points, std::numeric_limits<double>::infinity(), -1);
  }
  for (int round = 0; round < 12; ++round) {
    improve(shading, points, tukey_width(shading, points), -1);
  }
  double misfit = 0.0;
  for (const DiscPoint& point : points) {
    const double lit = std::max(0.0, point.normal.dot(shading.b));
    misfit += std::pow(point.value - lit - shading.ambient, 2);
  }
  shading.misfit = std::sqrt(misfit / double(points.size())) / deviation;
  shading.spread = deviation / std::max(mean, 1e-300);
  if (!shading.b.allFinite() || !std::isfinite(shading.ambient)) return MatteShading{};
  return shading;
}

// Variance of the direction by leaving out one block of the disc at a time (delete-a-group
// jackknife), per tangent axis.
double jackknife_variance(const MatteShading& shading, const std::vector<DiscPoint>& points) {
  const Eigen::Vector3d direction = shading.b.normalized();
  const double width = tukey_width(shading, points);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  std::array<Eigen::Vector3d, blocks> without;
  for (int block = 0; block < blocks; ++block) {
    MatteShading part = shading;
    for (int round = 0; round < 4; ++round) improve(part, points, width, block);
    without[std::size_t(block)] = part.b.normalized();
    mean += without[std::size_t(block)] / blocks;
  }
  double squares = 0.0;
  for (const auto& other : without) {
    const Eigen::Vector3d off = other - mean;
    squares += (off - off.dot(direction) * direction).squaredNorm();
  }
  return 0.5 * squares * (blocks - 1.0) / blocks;
}

}  // namespace

MatteShading matte_shading(const Grid<float>& grey, const Mask& saturated, const Camera& camera,
                           const Sphere& sphere, double rim) {
  return shading_of(disc_points(grey, saturated, camera, sphere, rim));
}

SphereReading read_matte_sphere(const Photographs& linear, const Sphere& sphere) {
  constexpr double rim = 0.95;
  SphereReading reading;
  reading.sphere = sphere;
  const std::size_t count = linear.images.size();
  reading.lights.resize(count);
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  reading.highlights_px.assign(count, {nowhere, nowhere});
  reading.dark.assign(count, Eigen::Vector3d::Constant(nowhere));
  std::vector<double> misfits(count);
  for_each_index(int(count), [&](int picture) {
    const auto k = std::size_t(picture);
    const Image& image = linear.images[k];
    const auto points =
        disc_points(luminance(image), linear.saturated[k], linear.camera, sphere, rim);
    const MatteShading shading = shading_of(points);
    Light& light = reading.lights[k];
    light.image = linear.file.pictures[k].name;
    light.direction_sigma = std::numeric_limits<double>::infinity();
    misfits[k] = shading.misfit;
    if (!(shading.b.norm() > 0.0) || shading.b.z() <= 0.0 || shading.misfit > hopeless_misfit) {
      return;
    }
    light.direction = shading.b.normalized();
    const double circle = sphere.sigma_px / sphere.radius_px;
    // A shading error that grows evenly across the disc tilts the light by half of the contrast it
    // leaves unexplained; how much of the misfit is of that kind nobody knows: half of the worst.
    const double not_lambertian = 0.25 * shading.misfit;
    light.direction_sigma = std::sqrt(jackknife_variance(shading, points) + circle * circle +
                                      not_lambertian * not_lambertian);
    for (int c = 0; c < 3; ++c) {
      const auto& plane = image.planes[std::size_t(std::min(c, image.channels() - 1))];
      const MatteShading of_channel =
          image.channels() == 1
              ? shading
              : matte_shading(plane, linear.saturated[k], linear.camera, sphere, rim);
      light.strength[c] = of_channel.b.norm();
      if (dark_side(shading.b, points)) reading.dark[k][c] = of_channel.ambient;
    }
    const Eigen::Vector2d towards(light.direction.x(), -light.direction.y());
    reading.highlights_px[k] = sphere.center_px + sphere.radius_px * towards;
  });
  reading.misfit = median(misfits);
  return reading;
}

}  // namespace hada
