#include "app/comparison.h"

#include <cmath>

#include <gtest/gtest.h>

#include "synth/synthesize.h"

namespace hada {
namespace {

constexpr Extent extent{.rows = 256, .cols = 256, .pitch = 0.2, .unit = Unit::mm};

TEST(SpectralFloor, IsTheDistanceOfTwoRealisations) {
  const Wrinkle<> wrinkle{{{0.3, 1.0, 0.6, 0.5}}, 1e-4};
  double distance = 0.0, floor = 0.0;
  constexpr int pairs = 6;
  for (int pair = 0; pair < pairs; ++pair) {
    const auto comparison = compare(synthesize(wrinkle, extent, Seed(2 * pair)),
                                    synthesize(wrinkle, extent, Seed(2 * pair + 1)));
    distance += std::pow(comparison.spectral_distance_db, 2) / pairs;
    floor += std::pow(comparison.spectral_floor_db, 2) / pairs;
  }
  // Dominated by the lowest rings of some ten ordinates, whose errors are known to a third each.
  EXPECT_GT(std::sqrt(distance / floor), 0.6);
  EXPECT_LT(std::sqrt(distance / floor), 1.6);
}

// The first ring of so small a map holds the mean alone: nothing.
TEST(SpectralFloor, HoldsForSmallMaps) {
  const Wrinkle<> wrinkle{{{0.3, 1.0, 0.6, 0.5}}, 1e-4};
  const Extent small{.rows = 100, .cols = 100, .pitch = 0.2, .unit = Unit::mm};
  const auto comparison = compare(synthesize(wrinkle, small, 1), synthesize(wrinkle, small, 2));
  ASSERT_EQ(comparison.second.rings.count.front(), 0);
  EXPECT_LT(comparison.spectral_distance_db, 2.0 * comparison.spectral_floor_db);
}

TEST(SpectralFloor, IsExceededByAnotherSpectrum) {
  const Wrinkle<> one{{{0.3, 1.0, 0.6, 0.5}}, 1e-4}, other{{{0.3, 2.0, 1.0, 0.5}}, 1e-4};
  const auto comparison = compare(synthesize(one, extent, 1), synthesize(other, extent, 2));
  EXPECT_GT(comparison.spectral_distance_db, 2.0 * comparison.spectral_floor_db);
}

}  // namespace
}  // namespace hada
