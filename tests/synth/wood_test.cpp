#include "synth/wood.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"

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
