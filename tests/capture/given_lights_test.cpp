#include "capture/given_lights.h"

#include <algorithm>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capture/find_spheres.h"
#include "table_scene.h"

namespace hada {
namespace {

using testing::HasSubstr;

class GivenLights : public testing::Test {
 protected:
  std::vector<std::string> remarks(const std::vector<Light>& lights) const {
    return remarks_on_given_lights(photographs_, lights, spheres_);
  }
  const Photographs photographs_ = table_scene({matte_at(-18.0, 9.0), chrome_at(-20.0, -9.0)});
  const std::vector<Sphere> spheres_ = find_spheres(photographs_).spheres;
};

TEST_F(GivenLights, AreBelievedWhereTheSpheresSeeThem) {
  ASSERT_EQ(spheres_.size(), 2u);
  EXPECT_THAT(remarks(six_lights()), testing::IsEmpty());
}

TEST_F(GivenLights, InAnotherOrderAreTold) {
  auto lights = six_lights();
  std::rotate(lights.begin(), lights.begin() + 1, lights.end());
  const auto said = remarks(lights);
  ASSERT_EQ(said.size(), 2u);
  EXPECT_THAT(said[0], HasSubstr("another order"));
}

TEST_F(GivenLights, OfARigThatWasMovedAreTold) {
  auto lights = six_lights();
  const Eigen::AngleAxisd turn(5.0 * degree, Eigen::Vector3d::UnitZ());
  for (Light& light : lights) light.direction = turn * light.direction;
  // Turned about the vertical, a light at a slant s moves by 5 sin s: 3.1 deg in the root mean.
  const auto said = remarks(lights);
  // The small chrome sphere is not sure enough of that.
  ASSERT_EQ(said.size(), 1u);
  EXPECT_THAT(said[0], HasSubstr("matte sphere"));
  EXPECT_THAT(said[0],
              testing::AnyOf(HasSubstr("3.0 deg"), HasSubstr("3.1 deg"), HasSubstr("3.2 deg")));
}

TEST_F(GivenLights, NearbyAreComparedWhereTheSphereLies) {
  // So far away that they are distant, and then so near that the spheres see them elsewhere.
  for (const double distance_mm : {1e5, 60.0}) {
    auto lights = six_lights();
    for (Light& light : lights) light.position = distance_mm * light.direction;
    EXPECT_EQ(remarks(lights).empty(), distance_mm == 1e5) << distance_mm;
  }
}

}  // namespace
}  // namespace hada
