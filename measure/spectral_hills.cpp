#include "measure/spectral_hills.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/field.h"
#include "core/parallel.h"
#include "measure/hills.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int sectors = 36;
constexpr double ring_growth = 1.08;     // of neighbouring rings
constexpr double least_width = 1.0;      // of the smoothing, in frequency steps
constexpr double relative_width = 0.08;  // of the smoothing, as a share of the frequency
constexpr double surprise = 3.0;         // deviations of a smoothed logarithm that chance is given
constexpr float slope_depth = 4.6f;      // nepers below its summit that a hill reaches down: 1 %

/// The logarithm of the smoothed power per octave and angle, at nodes of a log-polar lattice over
/// half a plane. Frequencies count steps of the spectrum.
struct Relief {
  Grid<float> height;     // rings x sectors
  Grid<float> deviation;  // of a node, by chance
  double lowest = 1.0;    // frequency of the first ring

  double frequency(int ring) const { return lowest * std::pow(ring_growth, ring); }
  int ring(double frequency) const {
    const int nearest = int(std::lround(std::log(frequency / lowest) / std::log(ring_growth)));
    return std::clamp(nearest, 0, height.rows() - 1);
  }
  int sector(double angle) const {
    return int(std::lround(half_turn(angle) / pi * sectors)) % sectors;
  }
};

double steps_of(const Spectrum& spectrum) {
  return std::max(spectrum.extent.width(), spectrum.extent.height());
}

struct Smoothed {
  double power = 0.0;
  double ordinates = 0.0;  // independent ones
};

// The mean power around (fx, fy), weighted by a Gaussian of standard deviation `width`, all in
// cycles per unit.
Smoothed smoothed(const Spectrum& spectrum, double fx, double fy, double width) {
  const Extent& extent = spectrum.extent;
  const int rows = spectrum.power.rows(), cols = spectrum.power.cols();
  constexpr double reach = 2.5;
  const int row_low = int(std::ceil((-fy - reach * width) * extent.height()));
  const int row_high = int(std::floor((-fy + reach * width) * extent.height()));
  const int col_low = int(std::ceil((fx - reach * width) * extent.width()));
  const int col_high = int(std::floor((fx + reach * width) * extent.width()));
  double sum = 0.0, weights = 0.0, squares = 0.0;
  for (int i = std::max(row_low, -(rows - 1) / 2); i <= std::min(row_high, (rows - 1) / 2); ++i) {
    for (int j = std::max(col_low, -(cols - 1) / 2); j <= std::min(col_high, (cols - 1) / 2); ++j) {
      if (i == 0 && j == 0) continue;
      const double dx = j / extent.width() - fx, dy = -i / extent.height() - fy;
      const double weight = std::exp(-0.5 * (dx * dx + dy * dy) / (width * width));
      sum += weight * spectrum.power((i + rows) % rows, (j + cols) % cols);
      weights += weight;
      squares += weight * weight;
    }
  }
  if (!(weights > 0.0)) return {};
  return {sum / weights, spectrum.independence * weights * weights / squares};
}

Relief relief_of(const Spectrum& spectrum) {
  const double step = 1.0 / steps_of(spectrum);
  const double highest = 0.5 / spectrum.extent.pitch / step;
  Relief relief;
  const int rings = int(std::log(highest / relief.lowest) / std::log(ring_growth));
  relief.height = Grid<float>(std::max(rings, 1), sectors);
  relief.deviation = relief.height;
  for_each_index(relief.height.rows(), [&](int ring) {
    const double f = relief.frequency(ring) * step;
    const double width = std::max(least_width * step, relative_width * f);
    for (int sector = 0; sector < sectors; ++sector) {
      const double angle = pi * sector / sectors;
      const auto mean = smoothed(spectrum, f * std::cos(angle), f * std::sin(angle), width);
      relief.height(ring, sector) = float(std::log(std::max(mean.power * f * f, 1e-300)));
      relief.deviation(ring, sector) = float(1.0 / std::sqrt(std::max(mean.ordinates, 1.0)));
    }
  });
  return relief;
}

// By the place of every ordinate on the relief.
Grid<int> hills_of_ordinates(const Spectrum& spectrum, const Relief& relief, const Hills& hills) {
  std::vector<float> summit(std::size_t(hills.count), -HUGE_VALF);
  for (std::size_t node = 0; node < relief.height.size(); ++node) {
    float& highest = summit[std::size_t(hills.of_pixel[node])];
    highest = std::max(highest, relief.height[node]);
  }
  const double step = 1.0 / steps_of(spectrum);
  const double nyquist = 0.5 / spectrum.extent.pitch;
  Grid<int> band(spectrum.power.rows(), spectrum.power.cols(), -1);
  for_each_index(band.rows(), [&](int row) {
    for (int col = 0; col < band.cols(); ++col) {
      const double fx = spectrum.fx(col), fy = spectrum.fy(row);
      const double f = std::hypot(fx, fy);
      if (f == 0.0 || f > nyquist) continue;
      const int ring = relief.ring(f / step), sector = relief.sector(std::atan2(fy, fx));
      const int number = hills.of_pixel(ring, sector);
      if (relief.height(ring, sector) > summit[std::size_t(number)] - slope_depth) {
        band(row, col) = number;
      }
    }
  });
  return band;
}

}  // namespace

SpectralHills spectral_hills(const Spectrum& spectrum) {
  const Relief relief = relief_of(spectrum);
  const auto found =
      hills(relief.height, Mask(relief.height.rows(), relief.height.cols(), 1),
            {.least_rise = [&](std::size_t node) { return surprise * relief.deviation[node]; },
             .columns_wrap = true});
  return {hills_of_ordinates(spectrum, relief, found), found.count};
}

}  // namespace hada
