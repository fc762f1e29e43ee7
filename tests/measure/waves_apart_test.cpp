#include "measure/waves_apart.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"
#include "core/surface.h"
#include "synth/gaussian_field.h"

namespace hada {
namespace {

constexpr Extent extent{.rows = 200, .cols = 240, .pitch = 0.5, .unit = Unit::mm};

const SpectralHump longer{std::log(1.0), std::log(1 / 30.0), std::log(0.18), std::log(0.25), 0.4,
                          false};
const SpectralHump shorter{std::log(0.1), std::log(1 / 12.0), std::log(0.15), std::log(0.2), 1.9,
                           false};

Grid<float> part_of(const SpectralHump& hump, Seed seed) {
  const auto field = gaussian_field(
      HumpDensity(hump), {2 * extent.rows, 2 * extent.cols, extent.pitch, extent.unit}, seed);
  return crop(field, 50, 70, extent.rows, extent.cols);
}

Grid<float> sum_of(Grid<float> one, const Grid<float>& two) {
  for (std::size_t i = 0; i < one.size(); ++i) one[i] += two[i];
  return one;
}

double mean_square(const Grid<float>& map, const Mask& mask) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (!mask[i]) continue;
    sum += double(map[i]) * map[i];
    count += 1.0;
  }
  return sum / count;
}

// A sheet with a hole and a slanted side: waves are told apart up to every border.
TEST(WavesApart, AreThoseThatWereAddedUp) {
  auto mask = full_mask(extent);
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      if (std::hypot(row - 80, col - 90) < 15 || col < row / 10) mask(row, col) = 0;
    }
  }
  HumpMixture mixture;
  mixture.humps = {longer, shorter};
  mixture.log_floor = mixture.log_fall = -30.0;
  const auto one = part_of(longer, 1), two = part_of(shorter, 2);
  const auto sum = sum_of(one, two);
  const auto apart = waves_apart(sum, mask, extent, mixture);
  ASSERT_TRUE(apart.of_hump[0] && apart.of_hump[1]);
  // Noise of 2 % of the map is let pass. Of the longer waves' power a thousandth lies where the
  // shorter ones are as strong; of the shorter ones' a tenth of that of the longer, 1 %.
  EXPECT_NEAR(apart.of_hump[0]->mean_square / mean_square(one, mask), 1.0, 0.02);
  EXPECT_NEAR(apart.of_hump[1]->mean_square / mean_square(two, mask), 1.0, 0.06);
  EXPECT_NEAR(apart.of_hump[0]->frequency_ratio, 1.0, 0.02);
  // What is left is no more than the noise.
  EXPECT_LT(std::sqrt(mean_square(apart.rest, mask) / mean_square(sum, mask)), 0.04);
}

// Long waves over a faint ground, on a sheet that is not a rectangle: descent by descent this takes
// thousands of rounds, and what is found before the end hangs on the rounding.
TEST(WavesApart, DoNotHangOnTheRounding) {
  HumpMixture mixture;
  mixture.humps = {longer, shorter};
  mixture.log_floor = std::log(1e-7);
  mixture.log_fall = std::log(1e-9);
  auto mask = full_mask(extent);
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) mask(row, col) = col > row / 8;
  }
  const auto map = sum_of(part_of(longer, 7), part_of(shorter, 8));
  auto rounded = map;
  for (std::size_t i = 0; i < map.size(); ++i) rounded[i] += 1e-5f * float(gaussian(9, int(i), 0));
  const auto one = waves_apart(map, mask, extent, mixture);
  const auto two = waves_apart(rounded, mask, extent, mixture);
  for (std::size_t k = 0; k < 2; ++k) {
    // The waves change by a thousandth of the noise, which is 2 % of the map.
    EXPECT_NEAR(one.of_hump[k]->mean_square / two.of_hump[k]->mean_square, 1.0, 2e-4) << k;
  }
}

TEST(WavesApart, LeaveShortWavesWhereTheyAre) {
  SpectralHump fine = shorter;
  fine.log_frequency = std::log(1 / 4.0);  // 4 steps of the coarse map
  HumpMixture mixture;
  mixture.humps = {longer, fine};
  mixture.log_floor = mixture.log_fall = -30.0;
  const auto one = part_of(longer, 3), two = part_of(fine, 4);
  const auto sum = sum_of(one, two);
  const auto mask = full_mask(extent);
  const auto apart = waves_apart(sum, mask, extent, mixture);
  EXPECT_TRUE(apart.of_hump[0]);
  EXPECT_FALSE(apart.of_hump[1]);
  Grid<float> off = apart.rest;
  for (std::size_t i = 0; i < off.size(); ++i) off[i] -= two[i];
  // The rest is the short waves, but for the noise that is let pass.
  EXPECT_LT(std::sqrt(mean_square(off, mask)), 0.1 * std::sqrt(mean_square(two, mask)));
}

TEST(WavesApart, OfAMaskOfHolesAreNone) {
  HumpMixture mixture;
  mixture.humps = {longer};
  Mask mask(extent.rows, extent.cols, 0);
  for (int row = 0; row < extent.rows; row += 3) {
    for (int col = 0; col < extent.cols; col += 3) mask(row, col) = 1;
  }
  EXPECT_FALSE(waves_apart(part_of(longer, 5), mask, extent, mixture).of_hump[0]);
}

TEST(WavesApart, MayBeOnAStrip) {
  HumpMixture mixture;
  mixture.humps = {longer};
  mixture.log_floor = mixture.log_fall = -30.0;
  const Extent strip{.rows = 20, .cols = 400, .pitch = 0.5, .unit = Unit::mm};
  const auto field = gaussian_field(HumpDensity(longer), {400, 800, 0.5, Unit::mm}, 6);
  const auto map = crop(field, 10, 20, strip.rows, strip.cols);
  const auto apart = waves_apart(map, full_mask(strip), strip, mixture);
  ASSERT_TRUE(apart.of_hump[0]);
  // But for the mean, which is no wave and on so narrow a strip may hold a part of one.
  EXPECT_NEAR(apart.of_hump[0]->mean_square / mean_square(map, full_mask(strip)), 1.0, 0.1);
}

TEST(WavesApart, OfAFlatMapAreNone) {
  HumpMixture mixture;
  mixture.humps = {longer};
  const auto apart =
      waves_apart(Grid<float>(extent.rows, extent.cols, 2.0f), full_mask(extent), extent, mixture);
  EXPECT_FALSE(apart.of_hump[0]);
}

}  // namespace
}  // namespace hada
