#include "synth/wood.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "synth/wood_solid.h"

namespace hada {
namespace {

TEST(EffectiveRadius, IsUndoneByTheRay) {
  const std::vector<GrowthLobe<>> lobes = {{2.0, 0.05, -0.02}, {1.0, 0.03, 0.04, 5.0, 15.0}};
  for (const double theta : {0.0, 1.0, 3.0, -2.0}) {
    for (const double rho : {2.0, 9.0, 30.0}) {
      const double r = GrowthRay(lobes, theta).radius_at(rho);
      EXPECT_NEAR(effective_radius(lobes, r, theta), rho, 1e-5);
    }
  }
}

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
TEST(SurfaceOfWood, HasTheDensityOfVessels) {
  Wood<> wood;
  wood.ring_radii_mm = {};
  wood.late_rgb = wood.early_rgb;
  wood.vessel_density_per_mm2 = 4.0;
  wood.vessel_radius_mm = 0.08;
  wood.vessel_radius_sd_mm = 0.0;
  wood.vessel_shade = 0.0;
  const auto surface = surface_of(wood, {600, 600, 0.02, Unit::mm}, 4);
  double dark = 0.0;
  for (const float value : surface.albedo.planes[0])
    dark += (1.0 - double(value) / wood.early_rgb[0]) / double(surface.albedo.planes[0].size());
  // Discs of a Poisson scatter cover 1 - exp(-density area); 576 of them scatter by 4 %.
  const double covered = 1.0 - std::exp(-4.0 * 3.14159265 * 0.08 * 0.08);
  EXPECT_NEAR(dark, covered, 3.0 * 0.042 * covered);
}

TEST(SurfaceOfWood, ShinesWhereFibresFaceTheLight) {
  Wood<> wood;
  wood.cut_origin_mm = {12.0, 0.0, 0.0};
  wood.cut_right = {0.0, 1.0, 0.0};
  wood.cut_up = {0.0, 0.0, 1.0};
  wood.figure_specular = 0.3;
  wood.figure_sharpness = 50.0;
  wood.wave_amplitude = 0.2;
  const Extent extent{64, 64, 0.2, Unit::mm};
  auto tilted = wood;
  tilted.figure_light_rad = 0.125;
  EXPECT_NE(surface_of(wood, extent, 1).albedo, surface_of(tilted, extent, 1).albedo);
}

TEST(SurfaceOfWood, RefusesACutThatIsNoPlane) {
  Wood<> wood;
  wood.cut_up = wood.cut_right;
  EXPECT_THROW(surface_of(wood, {8, 8, 0.1, Unit::mm}, 1), Error);
}

}  // namespace
}  // namespace hada
