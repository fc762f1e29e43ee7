#include "capture/diagnose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capture/light_stack.h"
#include "table_scene.h"

namespace hada {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

Photographs scene_of(const Rig& rig) {
  return photographs_of(photograph(waved_sheet(24.0), rig));
}

std::vector<std::string> remarks_under(const std::vector<Light>& lights) {
  Rig rig = table_rig({matte_at(-18.0, 0.0)});
  rig.lights = lights;
  return calibrate(scene_of(rig)).remarks;
}

TEST(Diagnose, HasNothingToSayOfAGoodCapture) {
  const Photographs photographs = table_scene({matte_at(-18.0, 9.0), chrome_at(-20.0, -9.0)});
  const Calibration calibration = calibrate(photographs);
  EXPECT_THAT(calibration.remarks, IsEmpty());
  EXPECT_THAT(remarks_on_lights(calibration.lights), IsEmpty());
  EXPECT_THAT(remarks_on_spheres(photographs, calibration), IsEmpty());
  std::vector<Sphere> spheres;
  for (const auto& reading : calibration.readings) spheres.push_back(reading.sphere);
  EXPECT_THAT(remarks_on_clipping(light_stack(photographs, calibration.lights, spheres)),
              IsEmpty());
}

TEST(Diagnose, SaysThatAllLightsAreFrontal) {
  EXPECT_THAT(
      remarks_under({light_at(12, 0), light_at(15, 90), light_at(14, 180), light_at(15, 270)}),
      Contains(HasSubstr("All lights come from within 15 degrees of the camera's axis")));
}

TEST(Diagnose, SaysThatAllLightsGraze) {
  EXPECT_THAT(
      remarks_under({light_at(74, 0), light_at(75, 90), light_at(76, 180), light_at(75, 270)}),
      Contains(HasSubstr("All lights graze the table (the highest stands 16 degrees")));
}

TEST(Diagnose, SaysThatAllLightsComeFromOneSide) {
  EXPECT_THAT(
      remarks_under({light_at(30, 0), light_at(45, 45), light_at(40, 90), light_at(35, 120)}),
      Contains(HasSubstr("from one side (over 240 degrees around the sample")));
  // A light overhead is on no side; three lights that go all around are on every side.
  EXPECT_THAT(remarks_on_lights({light_at(40, 0), light_at(40, 120), light_at(40, 240)}),
              IsEmpty());
  EXPECT_THAT(remarks_on_lights({light_at(40, 0), light_at(40, 90), light_at(5, 220)}),
              Contains(HasSubstr("from one side")));
}

TEST(Diagnose, NamesPicturesWithNearlyTheSameLight) {
  auto lights = six_lights();
  lights.push_back(light_at(45.8, 75, 0.95));
  EXPECT_THAT(
      remarks_under(lights),
      Contains(HasSubstr("picture_1.png and picture_6.png have nearly the same light (0.8")));
}

TEST(Diagnose, SaysThatTheBallIsSmall) {
  const auto photographs = table_scene({matte_at(-18.0, 0.0, 5.0)});
  EXPECT_THAT(calibrate(photographs).remarks,
              Contains(HasSubstr("The matte sphere is only 25 px across")));
}

TEST(Diagnose, NamesThePictureInWhichTheSphereIsDark) {
  auto lights = six_lights();
  lights[3].strength.setConstant(0.05);
  EXPECT_THAT(remarks_under(lights),
              Contains(AllOf(HasSubstr("The matte sphere at (60, 100)"), HasSubstr("picture_3.png"),
                             HasSubstr("too dark"))));
}

TEST(Diagnose, NamesThePictureInWhichAShadowLiesOnTheSphere) {
  // Ten degrees above the table, from behind the chrome sphere: its shadow covers all but the top.
  Rig rig = table_rig({matte_at(-18.0, -5.0), chrome_at(-18.0, 7.0)});
  rig.lights[2] = light_at(75, 90);
  EXPECT_THAT(calibrate(scene_of(rig)).remarks,
              Contains(AllOf(HasSubstr("The matte sphere at (60, 125)"), HasSubstr("picture_2.png"),
                             HasSubstr("shadow"))));
}

TEST(Diagnose, SaysWhereSphereAndSampleAreClipped) {
  Rig rig = table_rig({matte_at(-18.0, 0.0)});
  rig.exposure = 1.8;  // 1.8 * 0.6 of the sphere and 1.8 * 0.8 of the sheet reach beyond 1
  const Photographs photographs = scene_of(rig);
  const Calibration calibration = calibrate(photographs);
  EXPECT_THAT(calibration.remarks,
              Contains(AllOf(HasSubstr("is clipped on"), HasSubstr("picture_2.png"))));
  const LightStack stack =
      light_stack(photographs, calibration.lights, {calibration.readings[0].sphere});
  EXPECT_THAT(
      remarks_on_clipping(stack),
      Contains(AllOf(HasSubstr("The sample is clipped on up to"), HasSubstr("and 4 more"))));
}

}  // namespace
}  // namespace hada
