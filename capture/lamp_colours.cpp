#include "capture/lamp_colours.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "capture/ambient.h"
#include "core/error.h"
#include "core/quantile.h"

namespace hada {
namespace {

constexpr double most_pixels = 20000.0;
constexpr std::size_t fewest_pixels = 100;
constexpr float least_value = 0.02f;  // of the largest: darker pixels are noise, or lie in shadow

// The matte sphere that sees the most lights, the first of equals; null if there is none.
const SphereReading* best_matte(const std::vector<SphereReading>& readings) {
  const SphereReading* best = nullptr;
  std::ptrdiff_t most = 0;
  for (const SphereReading& reading : readings) {
    if (reading.sphere.kind != SphereKind::matte) continue;
    const auto seen = std::count_if(reading.lights.begin(), reading.lights.end(), is_seen);
    if (seen <= most) continue;
    most = seen;
    best = &reading;
  }
  return best;
}

std::vector<Eigen::Vector3d> colours_on(const SphereReading& reading) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double seen = 0.0;
  for (const Light& light : reading.lights) {
    if (!is_seen(light)) continue;
    if (!(light.strength.minCoeff() > 0.0)) {
      throw Error(light.image +
                  ": its light lacks a colour altogether; use white lamps, or grey pictures");
    }
    sum += light.strength;
    seen += 1.0;
  }
  std::vector<Eigen::Vector3d> colours(reading.lights.size(), Eigen::Vector3d::Ones());
  for (std::size_t k = 0; k < colours.size(); ++k) {
    if (is_seen(reading.lights[k]))
      colours[k] = reading.lights[k].strength.cwiseQuotient(sum / seen);
  }
  return colours;
}

bool lies_in_a_sphere(const std::vector<SphereReading>& readings, int row, int col) {
  const Eigen::Vector2d at(col + 0.5, row + 0.5);
  return std::any_of(readings.begin(), readings.end(), [&](const SphereReading& reading) {
    return (at - reading.sphere.center_px).norm() < reading.sphere.radius_px;
  });
}

// Logarithms of green and blue over red at a pixel, in each picture; empty if any is dark or
// saturated.
std::vector<Eigen::Vector2d> colour_ratios(const Photographs& linear, int row, int col) {
  std::vector<Eigen::Vector2d> ratios;
  for (std::size_t k = 0; k < linear.images.size(); ++k) {
    const auto& planes = linear.images[k].planes;
    const float red = planes[0](row, col);
    const float green = planes[1](row, col);
    const float blue = planes[2](row, col);
    if (linear.saturated[k](row, col) || std::min({red, green, blue}) < least_value) return {};
    ratios.emplace_back(std::log(double(green) / red), std::log(double(blue) / red));
  }
  return ratios;
}

std::vector<Eigen::Vector3d> colours_of_frame(const Photographs& linear,
                                              const std::vector<SphereReading>& readings) {
  const std::size_t count = linear.images.size();
  const Extent& extent = linear.camera.extent;
  const int stride =
      std::max(1, int(std::sqrt(double(extent.rows) * double(extent.cols) / most_pixels)));
  std::vector<std::vector<double>> green(count), blue(count);
  for (int row = stride / 2; row < extent.rows; row += stride) {
    for (int col = stride / 2; col < extent.cols; col += stride) {
      if (lies_in_a_sphere(readings, row, col)) continue;
      const std::vector<Eigen::Vector2d> ratios = colour_ratios(linear, row, col);
      if (ratios.empty()) continue;
      Eigen::Vector2d mean = Eigen::Vector2d::Zero();
      for (const Eigen::Vector2d& ratio : ratios) mean += ratio / double(count);
      for (std::size_t k = 0; k < count; ++k) {
        green[k].push_back(ratios[k].x() - mean.x());
        blue[k].push_back(ratios[k].y() - mean.y());
      }
    }
  }
  for (const Image& image : linear.images) image.let_go();
  std::vector<Eigen::Vector3d> colours(count, Eigen::Vector3d::Ones());
  if (green[0].size() < fewest_pixels) return colours;
  for (std::size_t k = 0; k < count; ++k) {
    colours[k] = {1.0, std::exp(median(std::move(green[k]))), std::exp(median(std::move(blue[k])))};
  }
  return colours;
}

}  // namespace

std::vector<Eigen::Vector3d> lamp_colours(const Photographs& linear,
                                          const std::vector<SphereReading>& readings) {
  if (linear.images.front().channels() < 3) {
    return std::vector<Eigen::Vector3d>(linear.images.size(), Eigen::Vector3d::Ones());
  }
  const SphereReading* matte = best_matte(readings);
  std::vector<Eigen::Vector3d> colours =
      matte ? colours_on(*matte) : colours_of_frame(linear, readings);
  for (Eigen::Vector3d& colour : colours) colour /= grey_of(colour);
  return colours;
}

}  // namespace hada
