#include "measure/hump_mixture.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/surface.h"
#include "synth/gaussian_field.h"

namespace hada {
namespace {

constexpr Extent extent{.rows = 200, .cols = 240, .pitch = 0.5, .unit = Unit::mm};

HumpMixture two_waves() {
  HumpMixture mixture;
  mixture.humps = {{std::log(0.04), std::log(0.1), std::log(0.15), std::log(0.2), 0.6, false},
                   {std::log(0.01), std::log(0.3), std::log(0.12), std::log(0.2), 2.2, false}};
  mixture.log_floor = std::log(1e-6);
  mixture.log_fall = std::log(1e-8);
  return mixture;
}

Spectrum spectrum_of_field(const HumpMixture& mixture, Seed seed) {
  const auto field = gaussian_field(
      MixtureDensity(mixture), {2 * extent.rows, 2 * extent.cols, extent.pitch, extent.unit}, seed);
  return power_spectrum(crop(field, 30, 50, extent.rows, extent.cols), full_mask(extent), extent,
                        {.taper = 1.0});
}

TEST(SpectralPatches, HoldEveryOrdinateOfTheHalfPlaneOnce) {
  const auto patches = patches_of(spectrum_of_field(two_waves(), 1)).all;
  double ordinates = 0.0;
  for (const SpectralPatch& patch : patches) {
    const double f = std::hypot(patch.fx, patch.fy);
    EXPECT_GT(f, 1.2 / extent.height() - 1e-9);
    EXPECT_LT(f, 0.45 / extent.pitch + 1e-9);
    EXPECT_GT(patch.power, 0.0);
    ordinates += patch.count;
  }
  // Half the area of the ring between, in steps of the spectrum; its border is a chain of steps.
  const double outer = 0.45 / extent.pitch, inner = 1.2 / extent.height();
  const double expected =
      0.5 * M_PI * (outer * outer - inner * inner) * extent.width() * extent.height();
  EXPECT_NEAR(ordinates, expected, 0.01 * expected);
}

TEST(HumpMixture, IsFoundAgainFromNearby) {
  const HumpMixture truth = two_waves();
  HumpMixture start = truth;
  for (SpectralHump& hump : start.humps) {
    hump.log_variance += 0.5;
    hump.log_frequency += 0.1;
    hump.log_along += 0.3;
    hump.direction += 0.1;
  }
  const auto spectrum = spectrum_of_field(truth, 2);
  const auto fit = fitted(start, patches_of(spectrum).all, hump_bounds(spectrum.extent));
  for (std::size_t k = 0; k < 2; ++k) {
    const auto &found = fit.mixture.humps[k], &there = truth.humps[k];
    // Half of 120 x 100 mm2 times the hump's area holds some 30 and 200 waves, of which a taper
    // leaves a quarter: lengths to widths / sqrt(8) = 5 %, powers to 35 %; twice that.
    EXPECT_NEAR(found.log_frequency, there.log_frequency, 0.1);
    EXPECT_NEAR(found.direction, there.direction, 0.15);
    EXPECT_NEAR(found.log_variance, there.log_variance, 0.7);
  }
}

TEST(HumpMixture, GetsLikelierByEveryFit) {
  const auto spectrum = spectrum_of_field(two_waves(), 3);
  const auto patches = patches_of(spectrum).all;
  HumpMixture poor = two_waves();
  poor.humps[0].direction += 0.4;
  const auto once = fitted(poor, patches, hump_bounds(spectrum.extent));
  const auto again = fitted(once.mixture, patches, hump_bounds(spectrum.extent));
  EXPECT_LE(again.deviance, once.deviance);
  EXPECT_NEAR(again.deviance, once.deviance, 1.0);  // a nat tells nothing apart
}

TEST(HumpMixture, KeepsNoFlanksOfOtherHumps) {
  const auto patches = patches_of(spectrum_of_field(two_waves(), 4)).all;
  HumpMixture mixture = two_waves();
  EXPECT_EQ(without_flanks(mixture, patches).humps.size(), 2u);
  for (const SpectralHump& hump : mixture.humps)
    EXPECT_GT(prominence(hump, mixture, patches), 0.9);  // far apart, over a ground of 1e-3
  // A wider one of a hundredth of the power mends the flanks of the first: its waves lie below.
  SpectralHump flank = mixture.humps[0];
  flank.log_variance -= std::log(100.0);
  flank.log_along += std::log(2.0);
  flank.log_across += std::log(2.0);
  mixture.humps.insert(mixture.humps.begin(), flank);
  EXPECT_LT(prominence(flank, mixture, patches), 0.3);
  const auto kept = without_flanks(mixture, patches).humps;
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0].log_variance, two_waves().humps[0].log_variance);
}

TEST(HumpMixture, KeepsOneOfTwoThatAreOneHill) {
  const auto patches = patches_of(spectrum_of_field(two_waves(), 5)).all;
  HumpMixture mixture = two_waves();
  mixture.humps.push_back(mixture.humps[0]);
  mixture.humps.back().log_variance -= 0.1;
  const auto kept = without_flanks(mixture, patches).humps;
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0].log_variance, two_waves().humps[0].log_variance);
}

}  // namespace
}  // namespace hada
