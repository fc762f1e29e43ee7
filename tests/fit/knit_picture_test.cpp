#include "fit/knit_picture.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(KnitPicture, AveragesBlocksOfRootsAroundTheMiddle) {
  Surface surface;
  surface.extent = {13, 10, 0.1, Unit::mm};
  surface.mask = full_mask(surface.extent);
  surface.albedo = Image(Grid<float>(13, 10, 0.25f));
  surface.albedo.planes[0](6, 5) = 0.49f;
  surface.mask(0, 0) = 0;
  // A stitch of 0.8 mm is 8 px: blocks of 2 make it 4.
  const auto picture = knit_picture(surface, 0.8, 4.0);
  ASSERT_EQ(picture.mask.rows(), 6);
  ASSERT_EQ(picture.mask.cols(), 5);
  EXPECT_DOUBLE_EQ(picture.extent.pitch, 0.2);
  EXPECT_NEAR(picture.planes[0](2, 1), 0.5f, 1e-6f);
  EXPECT_NEAR(picture.planes[0](3, 2), (3 * 0.5f + 0.7f) / 4.0f, 1e-6f);
  EXPECT_EQ(picture.mask(0, 0), 0);
  EXPECT_EQ(picture.mask(0, 1), 1);
}

}  // namespace
}  // namespace hada
