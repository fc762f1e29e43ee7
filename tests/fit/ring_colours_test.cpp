#include "fit/ring_colours.h"

#include <gtest/gtest.h>

#include "synth/synthesize.h"

namespace hada {
namespace {

TEST(RingColours, AreThoseOfTheStem) {
  Wood<> wood;
  wood.lobes = {};
  wood.ring_radii_mm = {3.0, 6.0, 9.0, 12.0};
  const Extent extent{280, 280, 0.1, Unit::mm};
  const auto surface = synthesize(wood, extent, 1);
  const auto [found, sigma] =
      ring_colours(surface, surface.mask, {{0.0, 0.0}, {}}, wood.ring_radii_mm);
  // A pixel is a thirtieth of a ring: the darkest and lightest places are seen to that.
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(found.early[c], wood.early_rgb[c], 0.035);
    EXPECT_NEAR(found.late[c], wood.late_rgb[c], 0.035);
    EXPECT_GT(sigma.early[c], 0.0);
  }
  EXPECT_NEAR(found.latewood_share, wood.latewood_share, 0.035);
}

}  // namespace
}  // namespace hada
