#include "core/light_stack.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(Arriving, FallsWithTheSquareOfTheDistanceAndIsNominalAtTheOrigin) {
  Light light;
  light.strength = {2.0, 1.0, 1.0};
  light.position = Eigen::Vector3d(0.0, 0.0, 300.0);
  EXPECT_NEAR(arriving(light, 0, Eigen::Vector3d::Zero()).norm(), 2.0, 1e-12);
  const Eigen::Vector3d half_way = arriving(light, 0, {0.0, 0.0, 150.0});
  EXPECT_NEAR(half_way.z(), 8.0, 1e-12);
  const Eigen::Vector3d aside = arriving(light, 1, {400.0, 0.0, 0.0});
  // 500 mm away: (300 / 500)^2 of the strength, along (-4, 0, 3) / 5.
  EXPECT_NEAR((aside - 0.36 * Eigen::Vector3d(-0.8, 0.0, 0.6)).norm(), 0.0, 1e-12);
}

TEST(Arriving, IsTheSameEverywhereFromADistantLight) {
  Light light;
  light.direction = {0.6, 0.0, 0.8};
  EXPECT_EQ(arriving(light, 2, {50.0, -20.0, 3.0}), light.direction);
  const Eigen::Vector3d point(50.0, -20.0, 3.0);
  EXPECT_NEAR((arriving<double>(light.direction, 0.0, point) - light.direction).norm(), 0.0, 1e-15);
}

}  // namespace
}  // namespace hada
