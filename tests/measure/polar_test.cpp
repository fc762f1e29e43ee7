#include "measure/polar.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "core/surface.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

/// Long axis at `angle`, with nothing near the Nyquist frequency.
Spectrum oriented(double angle, Seed seed) {
  const Extent extent{512, 512, 0.2, Unit::mm};
  const Wrinkle<> wrinkle{.components = {{0.5, 2.4, 0.8, angle}}};
  const auto surface = synthesize(wrinkle, extent, seed);
  return power_spectrum(surface.height, surface.mask, extent, {.taper = 0.0});
}

double total(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double variance(const Spectrum& spectrum) {
  double sum = 0.0;
  for (const double power : spectrum.power) sum += power;
  return sum / (spectrum.extent.width() * spectrum.extent.height());
}

TEST(Rings, ShareOutTheVariance) {
  const auto spectrum = oriented(0.4, 1);
  const auto summary = rings(spectrum);
  EXPECT_EQ(summary.power.size(), 64u);
  // The spectrum falls as exp(-4 pi^2 0.8^2 f^2) at least: e^-157 of its peak at the Nyquist
  // circle.
  EXPECT_NEAR(total(summary.power) / variance(spectrum), 1.0, 1e-6);
}

TEST(Rings, AreNoThinnerThanTheFrequencyStep) {
  const Extent extent{20, 40, 1.0, Unit::px};
  const auto spectrum = power_spectrum(Grid<float>(20, 40), full_mask(extent), extent);
  const auto summary = rings(spectrum);
  EXPECT_EQ(summary.power.size(), 10u);
  for (const int count : summary.count) EXPECT_GT(count, 0);
}

TEST(Rings, KnowTheirStandardError) {
  // The density in a ring of white noise, over 60 seeds, must scatter as `sigma` says. The standard
  // deviation of 60 numbers errs by 1 / sqrt(120) = 9 %; three of them, and the few per cent by
  // which a taper's shape in the plane is not a single number.
  const Extent extent{96, 96, 1.0, Unit::px};
  const int seeds = 60;
  double sum = 0.0, squares = 0.0, sigma = 0.0;
  for (Seed seed = 0; seed < seeds; ++seed) {
    Grid<float> map(96, 96);
    for (int i = 0; i < int(map.size()); ++i) map[std::size_t(i)] = float(gaussian(seed, i));
    const auto summary = rings(power_spectrum(map, full_mask(extent), extent), 4);
    sum += summary.density[2];
    squares += summary.density[2] * summary.density[2];
    sigma += summary.sigma[2] / seeds;
  }
  const double scatter = std::sqrt((squares - sum * sum / seeds) / (seeds - 1));
  EXPECT_NEAR(scatter / sigma, 1.0, 0.3);
}

TEST(Sectors, PeakAcrossTheLongAxis) {
  for (const double angle : {0.3, 1.2, 2.5}) {
    const auto summary = sectors(oriented(angle, 5), 18);
    const auto best = peaks(summary.power, 1, true);
    ASSERT_EQ(best.size(), 1u);
    const double turned = half_turn(summary.angle[std::size_t(best[0])] - angle - pi / 2 + pi / 4);
    // Power over the angle d from the peak goes as 1 / (1 + 8 sin^2 d): 0.65 at 15 deg. A top
    // sector rests on some 40 independent ordinates, a scatter of 16 %: two of them make 15 deg.
    EXPECT_NEAR(turned, pi / 4, 20.0 * pi / 180.0);  // 15 deg and half a sector
  }
}

TEST(Sectors, ShareOutTheVariance) {
  const auto spectrum = oriented(1.0, 8);
  EXPECT_NEAR(total(sectors(spectrum, 24).power) / variance(spectrum), 1.0, 1e-6);
}

TEST(Sectors, AreEvenWhereAFewSlowWavesHoldAllPower) {
  // No direction is preferred, and a few dozen ordinates of the lattice hold the power: sectors of
  // 5 degrees that took them whole would be full or empty.
  auto spectrum = oriented(0.4, 1);
  const double slow = 3.0 / spectrum.extent.width();
  for (int row = 0; row < spectrum.power.rows(); ++row) {
    for (int col = 0; col < spectrum.power.cols(); ++col) {
      const double f = std::hypot(spectrum.fx(col), spectrum.fy(row));
      spectrum.power(row, col) = std::exp(-f * f / (slow * slow));
    }
  }
  const auto density = sectors(spectrum).density;
  const auto [least, most] = std::minmax_element(density.begin(), density.end());
  // At a radius of 3 steps some 20 ordinates share the turn, with gaps: a third more here than
  // there.
  EXPECT_LT(*most, 1.5 * *least);
}

TEST(Peaks, AreLocalMaximaHighestFirst) {
  const std::vector<double> power{5, 1, 3, 2, 9, 4, 6};
  EXPECT_EQ(peaks(power, 9, false), (std::vector<int>{4, 6, 0, 2}));
  EXPECT_EQ(peaks(power, 9, true), (std::vector<int>{4, 6, 2}));  // 6 is next to 5
  EXPECT_EQ(peaks(power, 2, false), (std::vector<int>{4, 6}));
  EXPECT_TRUE(peaks({}, 3, true).empty());
}

}  // namespace
}  // namespace hada
