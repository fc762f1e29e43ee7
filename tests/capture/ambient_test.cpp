#include "capture/ambient.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capture/calibrate.h"
#include "capture/sphere_geometry.h"
#include "table_scene.h"

namespace hada {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

Photographs scene_with_ambient(double ambient) {
  auto rig = table_rig({matte_at(-18.0, 0.0, 12.0)});
  rig.ambient = ambient;
  return photographs_of(photograph(waved_sheet(24.0), rig));
}

TEST(AmbientLight, IsTakenOffAndTold) {
  const Calibration found = calibrate(scene_with_ambient(0.03));
  // The sheet is a third whiter than the sphere (0.8 to 0.6) and shows as much more of it; the fit
  // of the two leaves a tenth of the difference.
  EXPECT_NEAR(found.ambient_light[1], 0.03 * 0.8, 0.1 * 0.03 * 0.2);
  EXPECT_THAT(found.remarks, Contains(HasSubstr("was taken off all pictures")));
  const auto truth = six_lights();
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_FALSE(found.lights[k].position.has_value());
    // As without ambient light (RefinedLights.TakesLampsForDistantThatAre).
    EXPECT_LT(angle_deg(found.lights[k].direction, truth[k].direction), 0.1);
  }
}

TEST(AmbientLight, IsNoneInADarkRoom) {
  const Calibration found = calibrate(scene_with_ambient(0.0));
  EXPECT_TRUE(found.ambient_light.isZero());
  EXPECT_THAT(found.remarks, Not(Contains(HasSubstr("was taken off"))));
}

TEST(AmbientLight, IsNotTheMeanOfNoiseClippedAtZero) {
  auto rig = table_rig({matte_at(-18.0, 0.0, 12.0)});
  rig.read_noise = 0.02;
  const Calibration found = calibrate(photographs_of(photograph(waved_sheet(24.0), rig)));
  EXPECT_TRUE(found.ambient_light.isZero());
  for (const Light& light : found.lights) EXPECT_FALSE(light.position.has_value());
}

TEST(AmbientLight, SparesWhatTheSheetThrowsAtTheSphere) {
  // A dark side that shows thrown light alone, of a sphere that reflects 0.7 of it.
  SphereReading reading;
  reading.sphere.kind = SphereKind::matte;
  reading.sphere.center_px = {100.0, 100.0};
  reading.sphere.radius_px = 50.0;
  Camera camera;
  camera.extent = {200, 200, 1.0, Unit::px};
  MatteEvidence seen;
  const SphereInSpace ball = in_space(reading.sphere, camera);
  for (std::size_t k = 0; k < 6; ++k) {
    reading.lights.push_back(six_lights()[k]);
    reading.dark.push_back(Eigen::Vector3d::Constant(0.04));
  }
  seen.values.resize(6);
  seen.thrown.resize(6);
  for (int row = 55; row < 145; row += 4) {
    for (int col = 55; col < 145; col += 4) {
      const auto hit = first_hit<double>(camera.ray(col, row), ball.center, ball.radius);
      if (!hit) continue;
      seen.rays.push_back(camera.ray(col, row));
      for (std::size_t k = 0; k < 6; ++k) {
        seen.thrown[k].push_back(0.05 * (1.0 - hit->normal.z()));
        seen.values[k].push_back(0.7 * seen.thrown[k].back());
      }
    }
  }
  Evidence evidence;
  evidence.matte = {seen};
  EXPECT_TRUE(ambient_light(evidence, {reading}, camera).isZero());
  for (auto& values : evidence.matte[0].values) {
    for (double& value : values) value += 0.02;
  }
  EXPECT_NEAR(ambient_light(evidence, {reading}, camera)[0], 0.02, 1e-6);
}

}  // namespace
}  // namespace hada
