#include <gtest/gtest.h>

#include "capture/matte_sphere.h"
#include "table_scene.h"

namespace hada {
namespace {

TEST(Sharpen, FindsTheOutlineAgainFromAPixelAway) {
  const Photographs photographs = table_scene({matte_at(-18.0, 0.0)});
  const Sphere rough{SphereKind::matte, {60.8, 99.4}, 25.6, 0.5, {}};
  const Sphere sharp = sharpened_matte(photographs, rough);
  // 900 rim pixels in six pictures, each known to about 1 %: well under a tenth of a pixel.
  EXPECT_LT((sharp.center_px - Eigen::Vector2d(60.0, 100.0)).norm(), 0.1);
  EXPECT_NEAR(sharp.radius_px, 25.0, 0.1);
  EXPECT_LT(sharp.sigma_px, 0.1);
}

TEST(Sharpen, StaysWhereItIsIfTheSphereIsOutOfReach) {
  const Photographs photographs = table_scene({matte_at(-18.0, 0.0)});
  const Sphere elsewhere{SphereKind::matte, {80.0, 120.0}, 25.0, 0.5, {}};
  const Sphere sharp = sharpened_matte(photographs, elsewhere);
  EXPECT_LT((sharp.center_px - elsewhere.center_px).norm(), 2.0);
}

}  // namespace
}  // namespace hada
