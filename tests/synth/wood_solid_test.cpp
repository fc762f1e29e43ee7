#include "synth/wood_solid.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(WoodSolid, HasWholeYearsAtItsBoundaries) {
  Wood<> wood;
  wood.pith_mm = {1.0, -2.0};
  const WoodSolid solid(wood, 1);
  for (std::size_t k = 0; k < wood.ring_radii_mm.size(); ++k) {
    const auto place = solid.place_at({1.0 + wood.ring_radii_mm[k], -2.0, 0.0});
    EXPECT_NEAR(place.year, double(k + 1), 1e-9);
  }
}

TEST(WoodSolid, CarriesTheSectionAlongItsFibres) {
  Wood<> wood;
  wood.spiral = 0.12;
  wood.wave_amplitude = 0.2;
  wood.interlock_amplitude = 0.1;
  wood.fluctuation = 0.02;
  wood.lobes = {};
  const WoodSolid solid(wood, 3);
  // Follow the fibre up in small steps: it always leads back to the same place of the section.
  StemVector at = {7.0, 3.0, 0.0};
  const auto start = solid.place_at(at);
  constexpr double step = 0.01;
  for (int k = 0; k < 3000; ++k) {
    const StemVector here = solid.fibre_at(at);
    StemVector middle = at;
    for (std::size_t c = 0; c < 3; ++c) middle[c] += 0.5 * step * here[c];
    const StemVector half = solid.fibre_at(middle);
    for (std::size_t c = 0; c < 3; ++c) at[c] += step * half[c];
  }
  const auto end = solid.place_at(at);
  // The midpoint rule errs by step^2 times the length and a curvature of 0.2 per mm.
  EXPECT_NEAR(end.section_x, start.section_x, 1e-3);
  EXPECT_NEAR(end.section_y, start.section_y, 1e-3);
  EXPECT_GT(at[2], 28.0);
}

TEST(WoodSolid, HasTheGradientThatWasAsked) {
  Wood<> wood;
  wood.spiral = 0.05;
  wood.wave_amplitude = 0.2;
  wood.wave_length_mm = 20.0;
  const WoodSolid solid(wood, 1);
  const auto place = solid.place_at({9.0, 0.0, 5.0});
  EXPECT_NEAR(solid.gradient_at(place, 5.0), 0.05 + 0.2, 1e-4);  // the crest
  EXPECT_NEAR(solid.gradient_at(place, 10.0), 0.05, 1e-4);       // half a wave
}

/// The share of dark pixels and how many spots they form would be, from density and radius.

}  // namespace
}  // namespace hada
