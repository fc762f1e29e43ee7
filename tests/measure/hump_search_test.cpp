#include "measure/hump_search.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/surface.h"
#include "synth/gaussian_field.h"

namespace hada {
namespace {

constexpr Extent extent{.rows = 360, .cols = 440, .pitch = 0.5, .unit = Unit::mm};

template <class Psd>
HumpMixture found_in(const Psd& psd, Seed seed) {
  const auto field =
      gaussian_field(psd, {2 * extent.rows, 2 * extent.cols, extent.pitch, extent.unit}, seed);
  return humps_of(patches_of(power_spectrum(crop(field, 100, 60, extent.rows, extent.cols),
                                            full_mask(extent), extent, {.taper = 1.0})),
                  8);
}

TEST(HumpSearch, SeesWavesOnTheSlopeOfStrongerOnes) {
  // A factor of 2 in length and of 3 in height, 35 degrees apart: no hill of their own.
  HumpMixture truth;
  truth.humps = {{std::log(1.44), std::log(1 / 40.0), std::log(0.18), std::log(0.28), 0.8, false},
                 {std::log(0.144), std::log(1 / 20.0), std::log(0.14), std::log(0.18), 1.4, false}};
  truth.log_floor = std::log(1e-7);
  truth.log_fall = -30.0;
  for (const Seed seed : {1, 2, 3}) {
    auto found = found_in(MixtureDensity(truth), seed).humps;
    ASSERT_GE(found.size(), 2u) << seed;
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.log_variance > b.log_variance; });
    // The longer ones are a dozen waves, of which a taper leaves a quarter: 0.18 / sqrt(3) = 10 %.
    EXPECT_NEAR(found[0].log_frequency, truth.humps[0].log_frequency, 0.3) << seed;
    EXPECT_NEAR(found[1].log_frequency, truth.humps[1].log_frequency, 0.15) << seed;
  }
}

TEST(HumpSearch, FindsNoneInWhiteNoise) {
  EXPECT_TRUE(found_in([](double, double) { return 1e-4; }, 4).humps.empty());
}

TEST(HumpSearch, FindsNoneInAPowerLaw) {
  EXPECT_TRUE(
      found_in([](double fx, double fy) { return 1e-4 / std::pow(1e-4 + fx * fx + fy * fy, 1.2); },
               5)
          .humps.empty());
}

TEST(HumpSearch, FindsOneRing) {
  const SpectralHump ring{0.0, std::log(0.2), std::log(0.15), 0.0, 0.0, true};
  auto found =
      found_in([&](double fx, double fy) { return HumpDensity(ring)(fx, fy) + 1e-6; }, 6).humps;
  // A mixture may have humps as faint as what a taper lets through.
  std::erase_if(found, [](const SpectralHump& hump) { return std::exp(hump.log_variance) < 1e-5; });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].ring);
  EXPECT_NEAR(found[0].log_frequency, ring.log_frequency, 0.02);  // of a thousand waves
}

}  // namespace
}  // namespace hada
