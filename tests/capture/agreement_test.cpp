#include "capture/agreement.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "table_scene.h"

namespace hada {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Camera parallel_camera() {
  Camera camera;
  camera.extent = {200, 300, 0.2, Unit::mm};
  return camera;
}

// Two spheres that agree on six lights.
Calibration agreed() {
  Calibration calibration;
  calibration.lights = six_lights();
  for (std::size_t k = 0; k < 6; ++k) {
    calibration.lights[k].image = "picture_" + std::to_string(k) + ".png";
  }
  for (const double row : {30.0, 170.0}) {
    SphereReading reading;
    reading.sphere = {SphereKind::matte, {60.0, row}, 25.0, 0.1, {}};
    reading.lights = calibration.lights;
    for (Light& light : reading.lights) light.direction_sigma = 0.01;
    calibration.readings.push_back(reading);
  }
  return calibration;
}

Eigen::Matrix3d turned(double angle_deg, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle_deg * degree, axis.normalized()).toRotationMatrix();
}

TEST(Agreement, NamesThePictureInWhichOneSphereMoved) {
  Calibration calibration = agreed();
  EXPECT_THAT(remarks_on_agreement(calibration, parallel_camera()), IsEmpty());
  Eigen::Vector3d& direction = calibration.readings[1].lights[4].direction;
  direction = turned(12.0, direction.unitOrthogonal()) * direction;
  EXPECT_THAT(remarks_on_agreement(calibration, parallel_camera()),
              ElementsAre(HasSubstr("In picture_4.png the spheres disagree by 12.0 degrees")));
}

TEST(Agreement, TakesTheDistanceOfALampIntoAccount) {
  Calibration calibration = agreed();
  const Camera camera = parallel_camera();
  for (std::size_t k = 0; k < 6; ++k) {
    Light& light = calibration.lights[k];
    light.position = 100.0 * light.direction;
    // The spheres' middles lie 14 mm above and below that of the picture.
    for (const double y : {14.0, -14.0}) {
      calibration.readings[y > 0.0 ? 0 : 1].lights[k].direction =
          (*light.position - Eigen::Vector3d(-18.0, y, 5.0)).normalized();
    }
  }
  for (const auto& angle : disagreements(calibration, camera)) EXPECT_LT(angle.value(), 1e-9);
}

TEST(Agreement, NamesACameraThatIsNear) {
  Calibration calibration = agreed();
  for (SphereReading& reading : calibration.readings) {
    // What an eye 200 mm above the middle looks at squarely is taken to look straight up.
    const double y = reading.sphere.center_px.y() < 100.0 ? 14.0 : -14.0;
    const Eigen::Matrix3d turn = Eigen::Quaterniond::FromTwoVectors(
                                     Eigen::Vector3d(18.0, -y, 200.0), Eigen::Vector3d::UnitZ())
                                     .toRotationMatrix();
    for (Light& light : reading.lights) light.direction = turn * light.direction;
  }
  // Turns add up to second order in the place over the distance, a tenth of it.
  EXPECT_NEAR(distance_that_explains(calibration, parallel_camera()).value(), 200.0, 20.0);
  EXPECT_THAT(remarks_on_agreement(calibration, parallel_camera()),
              ElementsAre(AllOf(HasSubstr("on average"), HasSubstr("mm away: if yours"))));
}

TEST(Agreement, BlamesNoCameraForASphereThatIsTurned) {
  Calibration calibration = agreed();
  for (Light& light : calibration.readings[0].lights) {
    light.direction = turned(8.0, Eigen::Vector3d(0.0, 1.0, 0.0)) * light.direction;
  }
  EXPECT_THAT(remarks_on_agreement(calibration, parallel_camera()),
              ElementsAre(AllOf(HasSubstr("on average"), Not(HasSubstr("camera")))));
}

}  // namespace
}  // namespace hada
