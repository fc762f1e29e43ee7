#include "capture/matte_sphere.h"

#include <gtest/gtest.h>

#include "table_scene.h"

namespace hada {
namespace {

Sphere drawn_matte() {
  return {SphereKind::matte, {60.0, 100.0}, 25.0, 0.05, {}};
}

TEST(MatteSphere, ShadingPointsAtTheLight) {
  const Photographs photographs = table_scene({matte_at(-18.0, 0.0)});
  const auto truth = six_lights();
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const MatteShading shading =
        matte_shading(luminance(photographs.images[k]), photographs.saturated[k],
                      photographs.camera, drawn_matte());
    // 1800 pixels with noise of about 0.3 %: far below 0.1 degrees; the pixel grid adds a little.
    EXPECT_LT(angle_deg(shading.b, truth[k].direction), 0.15);
    // exposure 0.8, albedo 0.6; the mean of a clipped cosine over a pixel is off by under 1 %.
    EXPECT_NEAR(shading.b.norm(), 0.8 * 0.6 * truth[k].strength[0], 0.005);
    EXPECT_LT(shading.misfit, 0.05);
  }
}

TEST(MatteSphere, AmbientIsWhatTheDarkSideShows) {
  Rig rig = table_rig({matte_at(-18.0, 0.0)});
  rig.ambient = 0.05;
  rig.lights = {light_at(55, 20)};
  const Photographs photographs = photographs_of(photograph(waved_sheet(24.0), rig));
  const MatteShading shading =
      matte_shading(luminance(photographs.images[0]), photographs.saturated[0], photographs.camera,
                    drawn_matte());
  EXPECT_NEAR(shading.ambient, 0.05 * 0.6, 0.002);
  EXPECT_LT(angle_deg(shading.b, rig.lights[0].direction), 0.2);
}

TEST(MatteSphere, AHighlightDoesNotPullTheLight) {
  Photographs photographs = table_scene({matte_at(-18.0, 0.0)});
  Grid<float>& picture = photographs.images[0].planes[0];
  for (int row = 88; row < 96; ++row) {
    for (int col = 62; col < 70; ++col) picture(row, col) = 0.99f;
  }
  const MatteShading shading =
      matte_shading(picture, photographs.saturated[0], photographs.camera, drawn_matte());
  EXPECT_LT(angle_deg(shading.b, six_lights()[0].direction), 0.2);
}

TEST(MatteSphere, ReadingLeavesOutALightThatDoesNotReachIt) {
  Photographs photographs = table_scene({matte_at(-18.0, 0.0)});
  for (float& value : photographs.images[2].planes[0]) {
    value = 0.01f + 0.001f * float(uniform(
                                 1, std::int64_t(&value - photographs.images[2].planes[0].data())));
  }
  const SphereReading reading = read_matte_sphere(photographs, drawn_matte());
  EXPECT_FALSE(std::isfinite(reading.lights[2].direction_sigma));
  EXPECT_TRUE(std::isfinite(reading.lights[1].direction_sigma));
}

}  // namespace
}  // namespace hada
