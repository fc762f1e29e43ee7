#include "bench/texture_study.h"

#include <cmath>

#include "fit/wrinkle.h"
#include "measure/measured_map.h"
#include "measure/spectrum.h"
#include "synth/gaussian_field.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

constexpr int patch = 4;  // ordinates
constexpr Seed seed = 1;

Spectrum spectrum_of_map(const Grid<float>& map, const Extent& extent) {
  return power_spectrum(map, full_mask(extent), extent, {.taper = 1.0});
}

double distance_db(const Spectrum& a, const Spectrum& b) {
  double squares = 0.0;
  int patches = 0;
  for (int top = 0; top + patch <= a.power.rows(); top += patch) {
    for (int left = 0; left + patch <= a.power.cols(); left += patch) {
      double of_a = 0.0, of_b = 0.0;
      for (int row = top; row < top + patch; ++row) {
        for (int col = left; col < left + patch; ++col) {
          of_a += a.power(row, col);
          of_b += b.power(row, col);
        }
      }
      squares += std::pow(10.0 * std::log10(of_a / of_b), 2);
      ++patches;
    }
  }
  return std::sqrt(squares / patches);
}

double deviation(const Grid<float>& map) {
  double sum = 0.0, squares = 0.0;
  for (const float value : map) {
    sum += value;
    squares += double(value) * value;
  }
  const auto n = double(map.size());
  return std::sqrt(squares / n - sum / n * (sum / n));
}

}  // namespace

Surface piece_of(const Surface& picture, const PixelBox& box) {
  const auto [row, col, rows, cols] = box;
  Surface piece;
  piece.extent = picture.extent;
  piece.extent.rows = rows;
  piece.extent.cols = cols;
  piece.mask = crop(picture.mask, row, col, rows, cols);
  for (const auto& plane : picture.albedo.planes) {
    piece.albedo.planes.push_back(crop(plane, row, col, rows, cols));
  }
  return piece;
}

TextureScore study_texture(const Surface& picture, int components) {
  const Extent& extent = picture.extent;
  const auto brightness = measured_map(picture);
  const auto measured = spectrum_of_map(brightness, extent);
  const auto fit = fit_wrinkle(picture, {.components = components});
  const auto made = synthesize(fit.material, extent, seed).height;

  const auto raw = power_spectrum(brightness, full_mask(extent), extent, {.taper = 0.0});
  const auto same_spectrum = gaussian_field(
      [&](double fx, double fy) {
        const int row = int(std::lround(-fy * extent.height()));
        return raw.power((row + extent.rows) % extent.rows, int(std::lround(fx * extent.width())));
      },
      extent, seed + 1);
  return {.distance_db = distance_db(measured, spectrum_of_map(made, extent)),
          .floor_db = distance_db(measured, spectrum_of_map(same_spectrum, extent)),
          .std_ratio = deviation(made) / deviation(brightness)};
}

}  // namespace hada
