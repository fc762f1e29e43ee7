#include "mechanics/worn_maps.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace hada {
namespace {

using Eigen::Vector3d;

double through(const Vector3d& view) {
  return see_through(2.0, 1.0, 0.1, Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ(), view);
}

TEST(WornMaps, LetLightThroughTheGapsOfAGrid) {
  EXPECT_NEAR(through(Vector3d::UnitZ()), (1.0 - 0.2 / 2.0) * (1.0 - 0.2 / 1.0), 1e-15);
}

TEST(WornMaps, CloseTheGapsTowardsTheOutline) {
  // Tilted by 60 degrees about the courses: they look half as far apart, the wales as before.
  const Vector3d tilted(0.0, std::sin(M_PI / 3.0), 0.5);
  EXPECT_NEAR(through(tilted), (1.0 - 0.2 / 2.0) * (1.0 - 0.2 / 0.5), 1e-12);
  EXPECT_EQ(through(Vector3d(0.0, 1.0, 0.01).normalized()), 0.0);
}

TEST(WornMaps, CountStitchesAndPressOverTheirArea) {
  WornKnit knit;  // five courses of one point; soft ones press by 1, stiff ones by 3
  knit.net.courses = 5, knit.net.wales = 1;
  knit.places.assign(5, {0, 0, 0});
  knit.area_mm2.assign(5, 0.5), knit.press = {1.0, 3.0, 1.0, 3.0, 1.0};
  knit.wale_mm.assign(5, 1.0), knit.course_mm.assign(5, 0.5);
  EXPECT_EQ(densities(knit)[0], 2.0);
  EXPECT_EQ(pressures(knit, 1)[1], 6.0);
  for (const double pressure : pressures(knit, 2)) EXPECT_EQ(pressure, 4.0);  // cuffs too
  EXPECT_NEAR(transmittances(knit, 0.1)[0], 0.8 * 0.6, 1e-15);
}

}  // namespace
}  // namespace hada
