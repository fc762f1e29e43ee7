#include "capture/light_stack.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "io/image_file.h"
#include "table_scene.h"

namespace hada {
namespace {

TEST(LightStack, FindsTheSheetAndScalesTheStrengths) {
  const Sphere ball{SphereKind::matte, {60.0, 100.0}, 25.0, 0.1, {}};
  auto lights = six_lights();
  for (Light& light : lights) light.strength *= 7.0;
  const LightStack stack = light_stack(table_scene({matte_at(-18.0, 0.0)}), lights, {ball});
  int area = 0;
  for (const auto inside : stack.mask) area += inside;
  EXPECT_NEAR(area, 118 * 118, 120);  // 24 mm are 120 px; the border is taken off
  double sum = 0.0;
  for (const Light& light : stack.lights) sum += light.strength.mean();
  EXPECT_NEAR(sum / 6.0, 1.0, 1e-12);
}

TEST(LightStack, MarksShadowsAndSaturation) {
  Photographs photographs = table_scene({});
  photographs.images[0].planes[0](100, 200) = 0.001f;
  photographs.saturated[1](100, 200) = 1;
  const LightStack stack = light_stack(photographs, six_lights(), {});
  EXPECT_EQ(stack.samples[0](100, 200), Sample::shadowed);
  EXPECT_EQ(stack.samples[1](100, 200), Sample::saturated);
  EXPECT_EQ(stack.samples[2](100, 200), Sample::lit);
}

TEST(LightStack, NeedsThreePictures) {
  Photographs photographs = table_scene({});
  photographs.images.resize(2);
  photographs.saturated.resize(2);
  photographs.file.pictures.resize(2);
  EXPECT_THROW(light_stack(photographs, {light_at(30, 0), light_at(30, 90)}, {}), Error);
}

TEST(LightStack, MatchesLightsByNameAndElseByOrder) {
  CaptureFile file;
  for (const char* name : {"b.png", "a.png"}) file.pictures.push_back({name, name, {}, {}});
  std::vector<Light> lights{light_at(10, 0), light_at(20, 0)};
  lights[0].image = "a.png";
  lights[1].image = "b.png";
  EXPECT_EQ(matched_lights(lights, file)[0].direction, lights[1].direction);
  lights[0].image = "x.png";
  EXPECT_EQ(matched_lights(lights, file)[0].direction, lights[0].direction);
  lights.pop_back();
  EXPECT_THROW(matched_lights(lights, file), Error);
}

TEST(LightStack, MatchesLightsByNameWithoutEnding) {
  CaptureFile file;
  for (const char* name : {"b.tif", "a.tif"}) file.pictures.push_back({name, name, {}, {}});
  std::vector<Light> lights{light_at(10, 0), light_at(20, 0), light_at(30, 0)};
  lights[0].image = "a.jpg";
  lights[1].image = "c.jpg";
  lights[2].image = "b.jpg";
  const auto matched = matched_lights(lights, file);
  EXPECT_EQ(matched[0].direction, lights[2].direction);
  EXPECT_EQ(matched[1].direction, lights[0].direction);
  EXPECT_EQ(matched[0].image, "b.tif");
}

TEST(LightStack, KeepsErrorModesWithTheirLights) {
  Photographs photographs;
  for (const char* name : {"b.png", "a.png"}) {
    photographs.file.pictures.push_back({name, name, {}, {}});
  }
  LightsFile file;
  file.lights = {light_at(10, 0), light_at(20, 0)};
  file.lights[0].image = "a.png";
  file.lights[1].image = "b.png";
  file.errors = {{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()}};
  const LightsFile matched = matched_lights(file, photographs);
  EXPECT_EQ(matched.lights[0].direction, file.lights[1].direction);
  EXPECT_EQ(matched.errors[0][0], Eigen::Vector3d::UnitY());
  EXPECT_EQ(matched.errors[0][1], Eigen::Vector3d::UnitX());
}

TEST(LightStack, TakesPositionsOnlyInTheUnitOfThePictures) {
  Photographs photographs;
  photographs.file.pictures.push_back({"a.png", "a.png", {}, {}});
  LightsFile file;
  file.lights = {light_at(10, 0)};
  file.lights[0].position = Eigen::Vector3d(0.0, 0.0, 400.0);
  for (const Unit of_lights : {Unit::mm, Unit::px}) {
    for (const Unit of_pictures : {Unit::mm, Unit::px}) {
      file.position_unit = of_lights;
      photographs.camera.extent.unit = of_pictures;
      if (of_lights == of_pictures) {
        EXPECT_TRUE(matched_lights(file, photographs).lights[0].position);
      } else {
        EXPECT_THROW(matched_lights(file, photographs), Error);
      }
    }
  }
}

TEST(LightStack, RefusesAManifestThatGivesOnlySomeLights) {
  CaptureFile file;
  file.pictures.push_back({"a.png", "a.png", Eigen::Vector3d::UnitZ(), {}});
  EXPECT_EQ(lights_in(file).size(), 1u);
  file.pictures.push_back({"b.png", "b.png", {}, {}});
  EXPECT_THROW(lights_in(file), Error);
}

TEST(LightStack, IsTheSameOfPicturesOnDisk) {
  const Photographs in_memory = table_scene({matte_at(-18.0, 0.0)});
  Photographs on_disk = in_memory;
  put_on_disk(on_disk);
  const LightStack expected = light_stack(in_memory, six_lights(), {});
  const LightStack found = light_stack(std::move(on_disk), six_lights(), {});
  EXPECT_EQ(found.images[0].memory(), scratch_files());
  EXPECT_EQ(found.samples[0].memory(), scratch_files());
  EXPECT_EQ(found.images, expected.images);
  EXPECT_EQ(found.samples, expected.samples);
  EXPECT_EQ(found.mask, expected.mask);
}

}  // namespace
}  // namespace hada
