#include "capture/chrome_sphere.h"

#include <gtest/gtest.h>

#include "table_scene.h"

namespace hada {
namespace {

Sphere drawn_chrome() {
  return {SphereKind::chrome, {60.0, 100.0}, 30.0, 0.05, {}};
}

TEST(ChromeSphere, HighlightMirrorsTheLight) {
  Rig rig = table_rig({chrome_at(-18.0, 0.0, 12.0)});
  rig.light_diameter = 5.0 * degree;
  rig.bits = 32;
  const Photographs photographs = photographs_of(photograph(waved_sheet(24.0), rig));
  const SphereReading reading = read_chrome_sphere(photographs, drawn_chrome());
  for (std::size_t k = 0; k < rig.lights.size(); ++k) {
    // The spot is about 1.3 px across at 30 px radius: a twentieth of it is 0.25 degrees.
    EXPECT_LT(angle_deg(reading.lights[k].direction, rig.lights[k].direction), 0.5);
    EXPECT_TRUE(std::isfinite(reading.lights[k].direction_sigma));
  }
}

TEST(ChromeSphere, ADarkPictureHasNoHighlight) {
  Photographs photographs = table_scene({chrome_at(-18.0, 0.0, 12.0)});
  for (float& value : photographs.images[1].planes[0]) value = 0.01f;
  const SphereReading reading = read_chrome_sphere(photographs, drawn_chrome());
  EXPECT_FALSE(std::isfinite(reading.lights[1].direction_sigma));
}

TEST(ChromeSphere, ClippedHighlightsSayNothingOfStrength) {
  Photographs photographs = table_scene({chrome_at(-18.0, 0.0, 12.0)});
  const SphereReading reading = read_chrome_sphere(photographs, drawn_chrome());
  for (const Light& light : reading.lights) EXPECT_EQ(light.strength, Eigen::Vector3d::Ones());
}

}  // namespace
}  // namespace hada
