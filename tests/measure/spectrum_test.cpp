#include "measure/spectrum.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "core/surface.h"

namespace hada {
namespace {

Grid<float> white_noise(const Extent& extent, double sigma, Seed seed) {
  Grid<float> map(extent.rows, extent.cols);
  for (int row = 0; row < map.rows(); ++row) {
    for (int col = 0; col < map.cols(); ++col) {
      map(row, col) = float(sigma * gaussian(seed, row, col));
    }
  }
  return map;
}

double mean_of(const Grid<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / double(values.size());
}

Mask disc(const Extent& extent, double radius) {
  Mask mask(extent.rows, extent.cols);
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      mask(row, col) = extent.place(row, col).norm() < radius ? 1 : 0;
    }
  }
  return mask;
}

TEST(Spectrum, OfWhiteNoiseIsFlatAtItsVarianceTimesThePixelArea) {
  const Extent extent{120, 150, 0.2, Unit::mm};
  const auto map = white_noise(extent, 3.0, 1);
  const auto spectrum = power_spectrum(map, full_mask(extent), extent);
  // The mean of n independent exponentials errs by 1 / sqrt(n), n = half the ordinates (the other
  // half mirrors them) times `independence`: 1.2 %. Four of them.
  const double sigma = 1.0 / std::sqrt(0.5 * double(map.size()) * spectrum.independence);
  EXPECT_NEAR(mean_of(spectrum.power) / (9.0 * 0.04), 1.0, 4.0 * sigma);
  EXPECT_LT(sigma, 0.013);
}

TEST(Spectrum, SumsToTheVarianceOfTheMap) {
  const Extent extent{64, 96, 0.5, Unit::mm};
  const auto map = white_noise(extent, 2.0, 7);
  const auto spectrum = power_spectrum(map, full_mask(extent), extent, {.taper = 0.0});
  double mean = 0.0, square = 0.0;
  for (const float value : map) mean += value;
  mean /= double(map.size());
  for (const float value : map) square += (value - mean) * (value - mean);
  const double area = extent.width() * extent.height();
  // Parseval's theorem: exact but for rounding.
  EXPECT_NEAR(mean_of(spectrum.power) * double(map.size()) / area, square / double(map.size()),
              1e-9);
  EXPECT_DOUBLE_EQ(spectrum.independence, 1.0);
}

TEST(Spectrum, PutsAWaveAtItsFrequencyWithYUp) {
  const Extent extent{64, 64, 0.25, Unit::mm};
  const double fx = 5.0 / 16.0, fy = 9.0 / 16.0;  // whole waves on the 16 mm of the map
  Grid<float> map(64, 64);
  for (int row = 0; row < 64; ++row) {
    for (int col = 0; col < 64; ++col) {
      const auto at = extent.place(row, col);
      map(row, col) = float(std::cos(2.0 * std::numbers::pi * (fx * at.x() + fy * at.y())));
    }
  }
  const auto spectrum = power_spectrum(map, full_mask(extent), extent);
  const auto highest = std::max_element(spectrum.power.begin(), spectrum.power.end());
  const int index = int(highest - spectrum.power.begin());
  const double sign = spectrum.fx(index % 64) > 0.0 ? 1.0 : -1.0;
  EXPECT_DOUBLE_EQ(sign * spectrum.fx(index % 64), fx);
  EXPECT_DOUBLE_EQ(sign * spectrum.fy(index / 64), fy);
}

TEST(Spectrum, LeavesNothingAtFrequencyZero) {
  const Extent extent{40, 40, 1.0, Unit::px};
  auto map = white_noise(extent, 1.0, 3);
  for (float& value : map) value += 100.0f;
  const auto spectrum = power_spectrum(map, full_mask(extent), extent);
  // Rounding of a sum of 1600 doubles near 100, squared.
  EXPECT_LT(spectrum.power(0, 0), 1e-18);
}

TEST(Spectrum, NeverReadsOutsideTheMask) {
  const Extent extent{90, 110, 0.2, Unit::mm};
  const auto mask = disc(extent, 8.0);
  auto map = white_noise(extent, 1.0, 5);
  const auto spectrum = power_spectrum(map, mask, extent);
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (!mask[i]) map[i] = std::nanf("");
  }
  EXPECT_EQ(power_spectrum(map, mask, extent).power, spectrum.power);
}

TEST(Spectrum, OfWhiteNoiseIsFlatInsideADiscToo) {
  const Extent extent{200, 200, 0.2, Unit::mm};
  const auto spectrum = power_spectrum(white_noise(extent, 1.0, 9), disc(extent, 18.0), extent);
  const double sigma = 1.0 / std::sqrt(0.5 * double(spectrum.power.size()) * spectrum.independence);
  EXPECT_NEAR(mean_of(spectrum.power) / 0.04, 1.0, 4.0 * sigma);
  EXPECT_NEAR(spectrum.window_x, spectrum.window_y, 1e-3 * spectrum.window_x);
}

TEST(Spectrum, KnowsHowItsWindowNarrowsCorrelation) {
  const Extent extent{256, 128, 0.1, Unit::mm};
  const auto spectrum =
      power_spectrum(white_noise(extent, 1.0, 2), full_mask(extent), extent, {.taper = 0.5});
  // A Tukey window w of length L with share t of tapers: the integral of w^2 is L (1 - 5 t / 8),
  // that of (dw/dx)^2 is pi^2 / (2 t L). The sums over pixels differ from it by (pi / t n)^2 / 12.
  const auto curvature = [](double length) {
    const double pi = std::numbers::pi, t = 0.5;
    return pi * pi / (2.0 * t * length) / (2.0 * length * (1.0 - 5.0 * t / 8.0));
  };
  EXPECT_NEAR(spectrum.window_x / curvature(12.8), 1.0, 2e-3);
  EXPECT_NEAR(spectrum.window_y / curvature(25.6), 1.0, 1e-3);
}

TEST(Spectrum, MeasuresTheBoundingBoxOfTheMask) {
  const Extent extent{60, 80, 0.5, Unit::mm};
  Mask mask(60, 80);
  for (int row = 10; row < 40; ++row) {
    for (int col = 20; col < 70; ++col) mask(row, col) = 1;
  }
  const auto spectrum = power_spectrum(white_noise(extent, 1.0, 4), mask, extent);
  EXPECT_EQ(spectrum.extent, (Extent{30, 50, 0.5, Unit::mm}));
}

TEST(Spectrum, RefusesAMaskThatIsTooSmall) {
  const Extent extent{32, 32, 1.0, Unit::px};
  const Grid<float> map(32, 32);
  EXPECT_THROW(power_spectrum(map, Mask(32, 32), extent), Error);
  Mask strip(32, 32);
  for (int col = 0; col < 32; ++col) strip(4, col) = 1;
  EXPECT_THROW(power_spectrum(map, strip, extent), Error);
}

}  // namespace
}  // namespace hada
