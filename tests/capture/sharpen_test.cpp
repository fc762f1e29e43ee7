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

// Rough and dusty balls are brighter towards their rim than a Lambert one. Where all lamps stand on
// one side, that looks as if the ball were larger and lay further away from them.
TEST(Sharpen, IsNotMovedByABrightRim) {
  Rig rig = table_rig({matte_at(-15.0, 0.0, 20.0)});
  rig.lights = {light_at(20, 60), light_at(30, 90), light_at(35, 120), light_at(15, 90)};
  Photographs photographs = photographs_of(photograph(waved_sheet(24.0), rig));
  const Eigen::Vector2d center(75.0, 100.0);
  for (Image& image : photographs.images) {
    Grid<float>& plane = image.planes[0];
    for (int row = 0; row < plane.rows(); ++row) {
      for (int col = 0; col < plane.cols(); ++col) {
        const double r = (Eigen::Vector2d(col + 0.5, row + 0.5) - center).norm() / 50.0;
        if (r < 1.05) plane(row, col) *= float(1.0 + 0.5 * std::pow(r, 4.0));
      }
    }
  }
  const Sphere sharp =
      sharpened_matte(photographs, {SphereKind::matte, {75.3, 99.7}, 50.4, 0.5, {}});
  // The step at the rim is known as well as on a Lambert ball: to a tenth of a pixel.
  EXPECT_LT((sharp.center_px - center).norm(), 0.1);
  EXPECT_NEAR(sharp.radius_px, 50.0, 0.1);
}

TEST(Sharpen, StaysWhereItIsIfTheSphereIsOutOfReach) {
  const Photographs photographs = table_scene({matte_at(-18.0, 0.0)});
  const Sphere elsewhere{SphereKind::matte, {80.0, 120.0}, 25.0, 0.5, {}};
  const Sphere sharp = sharpened_matte(photographs, elsewhere);
  EXPECT_LT((sharp.center_px - elsewhere.center_px).norm(), 2.0);
}

}  // namespace
}  // namespace hada
