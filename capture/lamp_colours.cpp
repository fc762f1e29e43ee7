#include "capture/lamp_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "capture/ambient.h"
#include "core/error.h"
#include "core/quantile.h"
#include "core/surface.h"

namespace hada {
namespace {

constexpr double most_pixels = 20000.0;
constexpr std::size_t fewest_pixels = 100;
constexpr float least_value = 0.02f;  // of the brightest: darker ones are noise, or in shadow

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

using Pixel = std::array<float, 3>;

// What one picture shows at some pixels, and the brightest value of them.
struct Shown {
  std::vector<Pixel> pixels;
  float brightest = 0.0f;
};

Shown shown_at(const std::vector<std::pair<int, int>>& places, const Image& image) {
  Shown shown;
  for (const auto& [row, col] : places) {
    const Pixel pixel{image.planes[0](row, col), image.planes[1](row, col),
                      image.planes[2](row, col)};
    shown.brightest = std::max(shown.brightest, *std::max_element(pixel.begin(), pixel.end()));
    shown.pixels.push_back(pixel);
  }
  image.let_go();
  return shown;
}

// Logarithms of green and blue over red at a place, in each picture; empty if any is dark.
std::vector<Eigen::Vector2d> colour_ratios(const std::vector<Shown>& pictures, std::size_t place) {
  std::vector<Eigen::Vector2d> ratios;
  for (const Shown& shown : pictures) {
    const auto& [red, green, blue] = shown.pixels[place];
    if (!(std::min({red, green, blue}) > least_value * shown.brightest)) return {};
    ratios.emplace_back(std::log(double(green) / red), std::log(double(blue) / red));
  }
  return ratios;
}

// What is neither a sphere nor saturated in any picture.
Mask frame_of(const Photographs& linear, const std::vector<SphereReading>& readings) {
  Mask frame = full_mask(linear.camera.extent);
  for (const Mask& saturated : linear.saturated) {
    for (std::size_t i = 0; i < frame.size(); ++i) frame[i] &= saturated[i] == 0;
    saturated.let_go();
  }
  for (const SphereReading& reading : readings) {
    const auto [center, radius] = std::pair(reading.sphere.center_px, reading.sphere.radius_px);
    for (int row = int(center.y() - radius); row <= int(center.y() + radius); ++row) {
      for (int col = int(center.x() - radius); col <= int(center.x() + radius); ++col) {
        const bool inside = (Eigen::Vector2d(col + 0.5, row + 0.5) - center).norm() < radius;
        if (inside && frame.contains(row, col)) frame(row, col) = 0;
      }
    }
  }
  return frame;
}

void scale_to_grey(std::vector<Eigen::Vector3d>& colours) {
  for (Eigen::Vector3d& colour : colours) colour /= grey_of(colour);
}

}  // namespace

std::optional<std::vector<Eigen::Vector3d>> lamp_colours(const std::vector<Image>& images,
                                                         const Mask& counts) {
  if (images.front().channels() < 3) return std::nullopt;
  const int stride = std::max(1, int(std::sqrt(double(counts.size()) / most_pixels)));
  std::vector<std::pair<int, int>> places;
  for (int row = stride / 2; row < counts.rows(); row += stride) {
    for (int col = stride / 2; col < counts.cols(); col += stride) {
      if (counts(row, col)) places.emplace_back(row, col);
    }
  }
  std::vector<Shown> pictures;
  for (const Image& image : images) pictures.push_back(shown_at(places, image));
  std::vector<std::vector<double>> green(images.size()), blue(images.size());
  for (std::size_t place = 0; place < places.size(); ++place) {
    const std::vector<Eigen::Vector2d> ratios = colour_ratios(pictures, place);
    if (ratios.empty()) continue;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& ratio : ratios) mean += ratio / double(ratios.size());
    for (std::size_t k = 0; k < ratios.size(); ++k) {
      green[k].push_back(ratios[k].x() - mean.x());
      blue[k].push_back(ratios[k].y() - mean.y());
    }
  }
  if (green[0].size() < fewest_pixels) return std::nullopt;
  std::vector<Eigen::Vector3d> colours;
  for (std::size_t k = 0; k < images.size(); ++k) {
    colours.emplace_back(1.0, std::exp(median(std::move(green[k]))),
                         std::exp(median(std::move(blue[k]))));
  }
  scale_to_grey(colours);
  return colours;
}

std::vector<Eigen::Vector3d> lamp_colours(const Photographs& linear,
                                          const std::vector<SphereReading>& readings) {
  const std::vector<Eigen::Vector3d> white(linear.images.size(), Eigen::Vector3d::Ones());
  if (linear.images.front().channels() < 3) return white;
  if (const SphereReading* matte = best_matte(readings)) {
    std::vector<Eigen::Vector3d> colours = colours_on(*matte);
    scale_to_grey(colours);
    return colours;
  }
  return lamp_colours(linear.images, frame_of(linear, readings)).value_or(white);
}

std::array<float, 3> grey_weight(const Eigen::Vector3d& lamp_colour) {
  std::array<float, 3> weight = luminance_weight;
  for (std::size_t c = 0; c < 3; ++c) weight[c] /= float(lamp_colour[Eigen::Index(c)]);
  return weight;
}

}  // namespace hada
