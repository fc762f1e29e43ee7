#include "fit/end_grain.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

Wood<> stem() {
  Wood<> wood;
  wood.pith_mm = {2.0, -1.5};
  // Rings to beyond the corners: plain wood at the border would be taken for background.
  wood.ring_radii_mm = {3.0, 5.5, 8.0, 10.8, 13.0, 15.5, 18.0, 20.4, 23.0, 25.5};
  return wood;
}

TEST(EndGrain, FindsPithAndRingsOfAMadeStem) {
  const auto grain = end_grain(synthesize(stem(), {300, 300, 0.1, Unit::mm}, 2));
  EXPECT_TRUE(grain.pith_inside);
  // Without noise, a boundary is known to the pixel that holds it: 0.35 of it, and the pith better.
  EXPECT_LT((grain.shape.frame.pith - Eigen::Vector2d(2.0, -1.5)).norm(), 0.035);
  for (const double truth : {3.0, 5.5, 8.0, 10.8, 13.0, 15.5}) {
    double nearest = HUGE_VAL;
    for (const double found : grain.shape.radii)
      nearest = std::min(nearest, std::abs(found - truth));
    EXPECT_LT(nearest, 0.035) << truth;
  }
  EXPECT_EQ(grain.seen_share.size(), grain.shape.radii.size());
}

TEST(EndGrain, IsReadBetweenVessels) {
  // As many vessels as take a tenth of the wood, 5 px in radius, in rings of 40 to 80 px.
  auto wood = stem();
  for (double& radius : wood.ring_radii_mm) radius *= 0.25;
  wood.pith_mm = {-1.5, 0.4};
  wood.fibre_shift = 0.15;
  wood.vessel_density_per_mm2 = 13.0;
  wood.vessel_radius_mm = 0.05;
  wood.vessel_radius_sd_mm = 0.004;
  const auto grain = end_grain(synthesize(wood, {400, 400, 0.01, Unit::mm}, 5));
  EXPECT_LT((grain.shape.frame.pith - Eigen::Vector2d(-1.5, 0.4)).norm(), 0.0035);
  // Every ring that is found is one, but for those that only corners show.
  for (const double found : grain.shape.radii) {
    if (found > 2.5) continue;
    double nearest = HUGE_VAL;
    for (const double truth : wood.ring_radii_mm)
      nearest = std::min(nearest, std::abs(found - truth));
    EXPECT_LT(nearest, 0.01) << found;
  }
}

TEST(EndGrain, NeedsAnAlbedoWithRings) {
  Surface plain;
  plain.extent = {128, 128, 0.1, Unit::mm};
  plain.mask = full_mask(plain.extent);
  EXPECT_THROW(end_grain(plain), Error);
  plain.albedo = Image(Grid<float>(128, 128, 0.5f));
  EXPECT_THROW(end_grain(plain), Error);
}

}  // namespace
}  // namespace hada
