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

// What a window shows of the part that another shows too, 16 columns to its right.
void expect_same_where_they_overlap(const Material& material, double tolerance) {
  const Extent window{48, 64, 0.2, Unit::mm};
  const Surface here = synthesize_window(material, window, {1.0, 2.0}, 4);
  const Surface right = synthesize_window(material, window, {1.0 + 16 * 0.2, 2.0}, 4);
  for (int row = 0; row < 48; ++row) {
    for (int col = 16; col < 64; ++col) {
      ASSERT_NEAR(here.albedo.planes[0](row, col), right.albedo.planes[0](row, col - 16),
                  tolerance);
      if (!here.has_height()) continue;
      ASSERT_NEAR(here.height(row, col), right.height(row, col - 16), tolerance);
      ASSERT_NEAR((here.normals(row, col) - right.normals(row, col - 16)).norm(), 0.0, tolerance);
    }
  }
}

TEST(SynthesizeWindow, ShowsOneSheetOfWrinkles) {
  expect_same_where_they_overlap(Wrinkle<>{}, 2e-5);
}

TEST(SynthesizeWindow, ShowsOneCutOfWood) {
  Wood<> wood;
  wood.fluctuation = 0.05;
  wood.vessel_density_per_mm2 = 2.0;
  expect_same_where_they_overlap(wood, 1e-4);
}

TEST(SynthesizeWindow, RefusesWhatIsMadeAsAWhole) {
  EXPECT_THROW(synthesize_window(Knit<>{}, {48, 64, 0.2, Unit::mm}, {0.0, 0.0}, 1), Error);
  EXPECT_THROW(synthesize_window(Wrinkle<>{}, {48, 64, 0.2, Unit::mm}, {0.0, NAN}, 1), Error);
}

}  // namespace
}  // namespace hada
