#include "synth/synthesize.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"

namespace hada {
namespace {

TEST(Synthesize, MakesEveryMapOfASurface) {
  const Extent extent{48, 64, 0.25, Unit::mm};
  const auto surface = synthesize(Wrinkle<>{}, extent, 1);
  EXPECT_EQ(surface.extent, extent);
  EXPECT_TRUE(surface.height.same_size(surface.mask));
  EXPECT_TRUE(surface.normals.same_size(surface.mask));
  EXPECT_EQ(surface.albedo, Image(Grid<float>(48, 64, 0.8f)));
  EXPECT_EQ(surface.mask, full_mask(extent));
}

TEST(Synthesize, GivesNormalsThatBelongToTheHeight) {
  const Extent extent{64, 64, 0.1, Unit::mm};
  const auto surface = synthesize(Wrinkle<>{.components = {{0.2, 2.0, 1.0, 0.5}}}, extent, 2);
  const auto& h = surface.height;
  const auto& n = surface.normals(20, 30);
  EXPECT_NEAR(-n.x() / n.z(), (h(20, 31) - h(20, 29)) / 0.2, 1e-5);
  EXPECT_NEAR(-n.y() / n.z(), (h(19, 30) - h(21, 30)) / 0.2, 1e-5);
}

TEST(Synthesize, RefusesASurfaceWithoutPixelsOrPitch) {
  EXPECT_THROW(synthesize(Wrinkle<>{}, {0, 64, 0.1, Unit::mm}, 1), Error);
  EXPECT_THROW(synthesize(Wrinkle<>{}, {64, 64, 0.0, Unit::mm}, 1), Error);
  EXPECT_THROW(synthesize(Wrinkle<>{}, {64, 64, std::nan(""), Unit::mm}, 1), Error);
}

}  // namespace
}  // namespace hada
