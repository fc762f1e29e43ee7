#include "measure/decay.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/surface.h"
#include "synth/gaussian_field.h"

namespace hada {
namespace {

constexpr double plateau = 0.4, corner = 0.06, slope = 3.4, white = 2e-4;

double density(double fx, double fy) {
  return plateau * std::pow(1.0 + (fx * fx + fy * fy) / (corner * corner), -0.5 * slope) + white;
}

std::optional<Decay> decay_of_field(Seed seed) {
  const Extent extent{384, 384, 0.5, Unit::mm};
  const auto height = gaussian_field(density, extent, seed);
  return decay_of(rings(power_spectrum(height, full_mask(extent), extent)));
}

TEST(Decay, FindsCornerSlopeAndFloor) {
  constexpr int seeds = 12;
  double misses = 0.0;
  for (Seed seed = 1; seed <= seeds; ++seed) {
    const auto found = decay_of_field(seed);
    ASSERT_TRUE(found);
    // Rings up to f = 0.3, where the floor takes over, hold 10^4 independent ordinates, and those
    // beyond it 10^5: some hundredths of the slope and a per cent of the floor, four times that and
    // what the corner takes with it.
    EXPECT_NEAR(found->slope, slope, 0.3);
    EXPECT_NEAR(found->floor, white, 0.04 * white);
    ASSERT_TRUE(found->hurst());
    EXPECT_NEAR(*found->hurst(), 0.5 * (slope - 2.0), 0.15);
    misses += std::pow((found->slope - slope) / found->slope_sigma, 2) +
              std::pow((found->corner - corner) / found->corner_sigma, 2) +
              std::pow((found->floor - white) / found->floor_sigma, 2);
  }
  // 36 squares of unit variance, those of one field dependent: their mean scatters by 0.3 about 1,
  // and the error of a ring is itself known to a tenth.
  EXPECT_GT(misses / (3.0 * seeds), 0.4);
  EXPECT_LT(misses / (3.0 * seeds), 2.0);
}

TEST(Decay, KnowsNoHurstExponentOfASmoothSurface) {
  const Extent extent{256, 256, 1.0, Unit::mm};
  const auto smooth = [](double fx, double fy) { return std::exp(-400.0 * (fx * fx + fy * fy)); };
  const auto height = gaussian_field(smooth, extent, 3);
  const auto found = decay_of(rings(power_spectrum(height, full_mask(extent), extent)));
  ASSERT_TRUE(found);
  EXPECT_GT(found->slope, 6.0);
  EXPECT_FALSE(found->hurst());
}

TEST(Decay, IsNotReadOffAFewRings) {
  Rings few;
  for (int i = 1; i < 8; ++i) {
    few.frequency.push_back(i);
    few.density.push_back(1.0);
    few.sigma.push_back(0.1);
  }
  EXPECT_FALSE(decay_of(few));
}

}  // namespace
}  // namespace hada
