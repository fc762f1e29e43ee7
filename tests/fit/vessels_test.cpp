#include "fit/vessels.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"
#include "synth/wood.h"

namespace hada {
namespace {

Wood<> stem() {
  Wood<> wood;
  wood.pith_mm = {-9.0, 2.0};
  wood.fibre_shift = 0.15;
  wood.fibre_mm = 0.1;
  wood.ring_radii_mm.clear();
  double radius = 0.0;
  for (int k = 0; k < 12; ++k) wood.ring_radii_mm.push_back(radius += 2.0 + 0.8 * uniform(8, k));
  return wood;
}

/// Drawn twice as fine as it is looked at, with noise and 8 bits.
Surface picture(const Wood<>& wood) {
  constexpr int side = 520;
  const auto fine = surface_of(wood, {2 * side, 2 * side, 0.0125, Unit::mm}, 3).albedo;
  Surface surface;
  surface.extent = {side, side, 0.025, Unit::mm};
  surface.mask = full_mask(surface.extent);
  surface.albedo = Image(side, side, 3);
  for (std::size_t c = 0; c < 3; ++c) {
    for (int row = 0; row < side; ++row) {
      for (int col = 0; col < side; ++col) {
        double sum = 0.0;
        for (int k = 0; k < 4; ++k)
          sum += 0.25 * double(fine.planes[c](2 * row + k / 2, 2 * col + k % 2));
        sum += 0.01 * gaussian(7, row, col, int(c));
        surface.albedo.planes[c](row, col) = float(std::round(255.0 * sum) / 255.0);
      }
    }
  }
  return surface;
}

std::optional<Vessels> seen_in(const Wood<>& wood) {
  const Surface surface = picture(wood);
  return vessels_of(surface, end_grain(surface));
}

TEST(Vessels, OfADiffusePorousWoodAreCountedAndMeasured) {
  auto wood = stem();
  wood.vessel_density_per_mm2 = 2.0;
  wood.vessel_radius_mm = 0.13;
  wood.vessel_radius_sd_mm = 0.012;
  const auto vessels = seen_in(wood);
  ASSERT_TRUE(vessels);
  EXPECT_EQ(vessels->porosity, Porosity::diffuse);
  // Some 200 vessels: their number is luck to 7 %.
  EXPECT_NEAR(vessels->density.value, 2.0, 3.0 * vessels->density.sigma);
  EXPECT_LT(vessels->density.sigma, 0.25);
  EXPECT_NEAR(vessels->radius.value, 0.13, 0.03 * 0.13);
  EXPECT_NEAR(vessels->shade.value, wood.vessel_shade, 0.03);
}

TEST(Vessels, OfARingPorousWoodLieAlongTheBoundaries) {
  auto wood = stem();
  wood.ring_vessels_per_mm = 0.9;
  wood.ring_vessel_radius_mm = 0.17;
  const auto vessels = seen_in(wood);
  ASSERT_TRUE(vessels);
  EXPECT_EQ(vessels->porosity, Porosity::ring);
  EXPECT_EQ(vessels->density.value, 0.0);
  EXPECT_NEAR(vessels->ring_density.value, 0.9, 0.1 * 0.9);  // of some 50 vessels
  // Radii lie evenly within a quarter of their mean: 0.14 / sqrt(50) = 2 %, four times that.
  EXPECT_NEAR(vessels->ring_radius.value, 0.17, 0.08 * 0.17);
  EXPECT_NEAR(vessels->ring_radius.value, 0.17, 4.0 * vessels->ring_radius.sigma);
}

TEST(Vessels, AreNoneInSoftwood) {
  EXPECT_FALSE(seen_in(stem()));
}

TEST(Vessels, AreNotMeasuredWhereTheyAreTooSmall) {
  auto wood = stem();
  wood.vessel_density_per_mm2 = 4.0;
  wood.vessel_radius_mm = 0.06;  // 2.4 px
  wood.vessel_radius_sd_mm = 0.005;
  EXPECT_FALSE(seen_in(wood));
}

}  // namespace
}  // namespace hada
