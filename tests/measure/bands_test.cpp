#include "measure/bands.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "core/random.h"
#include "synth/gaussian_field.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
constexpr Extent world{.rows = 768, .cols = 768, .pitch = 0.25, .unit = Unit::mm};
constexpr Extent extent{.rows = 400, .cols = 480, .pitch = 0.25, .unit = Unit::mm};

/// Waves of one length and direction: a Gaussian hump at each of f and -f.
struct Waves {
  double wavelength, direction, rms, spread;

  double density(double fx, double fy) const {
    const double f = 1.0 / wavelength, width = spread * f;
    const double u = std::abs(fx * std::cos(direction) + fy * std::sin(direction)) - f;
    const double v = fy * std::cos(direction) - fx * std::sin(direction);
    return rms * rms / (4.0 * pi * width * width) *
           std::exp(-0.5 * (u * u + v * v) / (width * width));
  }
};

// A part of a larger field, so that it does not tile.
Grid<float> map_of(const std::vector<Waves>& waves, Seed seed) {
  const auto field = gaussian_field(
      [&](double fx, double fy) {
        double sum = 0.0;
        for (const Waves& one : waves) sum += one.density(fx, fy);
        return sum;
      },
      world, seed);
  return crop(field, 100, 60, extent.rows, extent.cols);
}

std::vector<Band> bands_of(const Grid<float>& map) {
  const Mask mask(map.rows(), map.cols(), 1);
  return bands(power_spectrum(map, mask, extent), map, mask);
}

TEST(Bands, AreTheWavesThatWereAddedUp) {
  const std::vector<Waves> waves{
      {16.0, 0.6, 0.4, 0.12}, {6.0, 2.5, 0.1, 0.12}, {2.5, 1.4, 0.02, 0.12}};
  const auto found = bands_of(map_of(waves, 3));
  ASSERT_EQ(found.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    // What is there scatters about the law by sigma; three of those, and 2 % for the far slopes.
    const Band& band = found[k];
    EXPECT_NEAR(band.wavelength, waves[k].wavelength,
                3.0 * band.wavelength_sigma + 0.02 * band.wavelength);
    EXPECT_NEAR(band.direction, waves[k].direction, 3.0 * band.direction_sigma + 0.01);
    EXPECT_NEAR(band.rms, waves[k].rms, 3.0 * band.rms_sigma + 0.02 * band.rms);
    EXPECT_GT(band.anisotropy, 0.9);
    EXPECT_LT(band.wavelength_sigma, 0.1 * band.wavelength);
  }
}

TEST(Bands, AreSeenThroughHolesAllOver) {
  const Grid<float> whole = map_of({{16.0, 0.6, 0.4, 0.12}, {4.0, 1.4, 0.05, 0.12}}, 3);
  const auto expected = bands_of(whole);
  ASSERT_EQ(expected.size(), 2u);
  Grid<float> torn = whole;
  Mask mask(extent.rows, extent.cols, 1);
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      const bool in_speck = uniform(6, row / 5, col / 5) < 0.003;  // 20 times as large as a pixel
      if (uniform(5, row, col) > 0.01 && !in_speck) continue;
      mask(row, col) = 0;
      torn(row, col) = 1e6f;
    }
  }
  const auto found = bands(power_spectrum(torn, mask, extent), torn, mask);
  ASSERT_EQ(found.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(found[k].wavelength, expected[k].wavelength, 0.01 * expected[k].wavelength);
    EXPECT_NEAR(found[k].direction, expected[k].direction, 0.01);
    EXPECT_NEAR(found[k].rms, expected[k].rms, 0.02 * expected[k].rms);
  }
}

TEST(Bands, OfOneLengthInAllDirectionsAreOne) {
  const auto ring = [](double fx, double fy) {
    const double off = std::hypot(fx, fy) * 3.0 - 1.0;
    return std::exp(-0.5 * off * off / 0.01);
  };
  const auto found = bands_of(crop(gaussian_field(ring, world, 8), 0, 0, extent.rows, extent.cols));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].wavelength, 3.0, 0.06);
  EXPECT_LT(found[0].anisotropy, 0.15);
}

TEST(Bands, KeepToWhatIsThereInAPureWave) {
  Grid<float> map(extent.rows, extent.cols);
  for (int row = 0; row < map.rows(); ++row) {
    for (int col = 0; col < map.cols(); ++col) {
      const auto place = extent.place(row, col);
      map(row, col) = float(0.3 * std::sin(2.0 * pi * (0.2 * place.x() + 0.1 * place.y())));
    }
  }
  const auto found = bands_of(map);
  ASSERT_FALSE(found.empty());
  EXPECT_NEAR(found[0].wavelength, 1.0 / std::hypot(0.2, 0.1), 0.02);
  EXPECT_NEAR(found[0].direction, std::atan2(0.1, 0.2), 0.01);
  EXPECT_NEAR(found[0].rms, 0.3 / std::sqrt(2.0), 0.003);
}

// Kernels about frequency 0, as those of wrinkles, are not of the shape of humps: several humps
// together make the hill of one.
TEST(Bands, AreOneForEveryKernelOfAnotherShape) {
  struct Kernel {
    double amplitude, along, across, angle;

    double density(double fx, double fy) const {
      const double u = 2.0 * pi * along * (fx * std::cos(angle) + fy * std::sin(angle));
      const double v = 2.0 * pi * across * (fy * std::cos(angle) - fx * std::sin(angle));
      return amplitude * amplitude * 4.0 * pi * along * across * std::exp(-u * u - v * v);
    }
  };
  const Kernel kernels[] = {{0.4, 9.0, 5.0, 0.3}, {0.1, 3.0, 1.6, 2.1}, {0.02, 1.0, 0.5, 1.1}};
  const auto density = [&](double fx, double fy) {
    double sum = 1e-8;
    for (const Kernel& kernel : kernels) sum += kernel.density(fx, fy);
    return sum;
  };
  const Extent sheet{.rows = 1200, .cols = 1200, .pitch = 0.15, .unit = Unit::mm};
  for (const Seed seed : {1, 2}) {
    const auto map = gaussian_field(density, sheet, seed);
    const Mask mask(sheet.rows, sheet.cols, 1);
    const auto found = bands(power_spectrum(map, mask, sheet), map, mask);
    ASSERT_EQ(found.size(), 3u) << seed;
    for (std::size_t k = 0; k < 3; ++k) {
      // Each is that of its kernel: they differ by factors of 4 and 5, and by 30 degrees or more.
      EXPECT_NEAR(std::log2(found[k].rms / kernels[k].amplitude), 0.0, 1.0) << k;
      const double across = kernels[k].angle + pi / 2;
      EXPECT_NEAR(std::remainder(found[k].direction - across, pi), 0.0, pi / 12) << k;
    }
  }
}

TEST(Bands, OfAFlatMapAreNone) {
  for (const float level : {0.0f, 0.1f, -1234.5f})
    EXPECT_TRUE(bands_of(Grid<float>(extent.rows, extent.cols, level)).empty()) << level;
}

TEST(Bands, AreTheSameInAnyUnit) {
  const auto map = map_of({{16.0, 0.6, 0.4, 0.12}, {3.0, 2.5, 0.1, 0.12}}, 6);
  const auto found = bands_of(map);
  constexpr double smaller = 1e-9;  // heights in nm, told in m
  Grid<float> small = map;
  for (float& height : small) height *= float(smaller);
  const Mask mask(map.rows(), map.cols(), 1);
  const Extent there{extent.rows, extent.cols, smaller * extent.pitch, extent.unit};
  const auto found_there = bands(power_spectrum(small, mask, there), small, mask);
  ASSERT_EQ(found.size(), found_there.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_NEAR(found_there[k].wavelength / found[k].wavelength / smaller, 1.0, 1e-3);
    EXPECT_NEAR(found_there[k].rms / found[k].rms / smaller, 1.0, 1e-3);
  }
}

TEST(Bands, AreTheSameAtAnyThreadCount) {
  const auto map = map_of({{16.0, 0.6, 0.4, 0.12}, {6.0, 2.5, 0.1, 0.12}}, 4);
  set_threads(1);
  const auto one = bands_of(map);
  set_threads(3);
  const auto three = bands_of(map);
  set_threads(0);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_EQ(one[k].rms, three[k].rms);
}

TEST(Bands, HaveTheMeanFrequencyOfLongWaves) {
  // Waves of 45 mm on a sheet of 200 x 150 mm. Side lobes of a cut would make them 6 % shorter.
  const auto density = [](double fx, double fy) {
    const double u = (std::abs(fx) - 1.0 / 45.0) * 45.0 / 0.25, v = fy * 45.0 / 0.4;
    return std::exp(-(u * u + v * v));
  };
  constexpr int count = 12;
  double bias = 0.0;
  for (int seed = 0; seed < count; ++seed) {
    const Extent sheet{.rows = 150, .cols = 200, .pitch = 1.0};
    const auto map = gaussian_field(density, sheet, Seed(seed));
    const Mask mask(sheet.rows, sheet.cols, 1);
    const auto whole = power_spectrum(map, mask, sheet, {.taper = 0.0});
    double power = 0.0, moment = 0.0;  // of what is there: the map tiles
    for (int row = 0; row < sheet.rows; ++row) {
      for (int col = 0; col < sheet.cols; ++col) {
        power += whole.power(row, col);
        moment += whole.power(row, col) * std::hypot(whole.fx(col), whole.fy(row));
      }
    }
    const auto found = bands(power_spectrum(map, mask, sheet), map, mask);
    ASSERT_FALSE(found.empty());
    bias += (found.front().wavelength * moment / power - 1.0) / count;
  }
  // Each scatters by 3 %, 12 of them by 1; the taper itself costs 2 to 3 % of such long waves.
  EXPECT_NEAR(bias, 0.0, 0.05);
}

}  // namespace
}  // namespace hada
