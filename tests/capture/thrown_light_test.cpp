#include "capture/thrown_light.h"

#include <numbers>

#include <gtest/gtest.h>

namespace hada {
namespace {

// 400 x 400 pixels of 0.1 mm: patches are squares of 1 mm.
const Camera camera{{400, 400, 0.1, Unit::mm}, Camera::Model::orthographic, 0.0};

TEST(ThrownLight, FillsAWhitePointThatLooksDownOnAWideSheet) {
  const std::vector<Grid<float>> greys{Grid<float>(400, 400, 0.6f)};
  const std::vector<Hit<double>> points{{{0.0, 0.0, 4.0}, -Eigen::Vector3d::UnitZ()}};
  const double thrown = thrown_light(greys, camera, {}, points)[0][0];
  // A square of half side a = 20 at the distance 4 fills 4 * 2 / (2 pi) * X atan X, X = a /
  // sqrt(a^2 + h^2), of the hemisphere: 0.974 (form factor of a point over a rectangle); patches of
  // 1 mm err by their size over the distance squared, over 24: 0.3 %.
  const double x = 20.0 / std::hypot(20.0, 4.0);
  const double factor = 4.0 / std::numbers::pi * x * std::atan(x);
  EXPECT_NEAR(thrown, 0.6 * factor, 0.6 * 0.005);
}

TEST(ThrownLight, FallsWithTheSquareOfTheDistanceToASmallPatch) {
  Grid<float> grey(400, 400);
  for (int row = 0; row < 10; ++row) {
    for (int col = 0; col < 10; ++col) grey(row + 200, col + 390) = 1.0f;
  }
  // The patch's middle is at (19.5, -0.5, 0); the point is 10 mm to its left and 5 mm above.
  const Eigen::Vector3d point(9.5, -0.5, 5.0);
  const std::vector<Hit<double>> points{{point, Eigen::Vector3d::UnitX()}};
  const double thrown = thrown_light({grey}, camera, {}, points)[0][0];
  const double square = 10.0 * 10.0 + 5.0 * 5.0;
  EXPECT_NEAR(thrown, 10.0 * 5.0 / (std::numbers::pi * square * square), 1e-9);
}

TEST(ThrownLight, DoesNotComeFromSpheresNorFromBehind) {
  const std::vector<Grid<float>> greys{Grid<float>(400, 400, 1.0f)};
  const std::vector<Hit<double>> up{{{0.0, 0.0, 4.0}, Eigen::Vector3d::UnitZ()}};
  EXPECT_EQ(thrown_light(greys, camera, {}, up)[0][0], 0.0);
  const std::vector<Hit<double>> down{{{0.0, 0.0, 4.0}, -Eigen::Vector3d::UnitZ()}};
  const Sphere everywhere{SphereKind::matte, {200.0, 200.0}, 300.0, 0.1, {}};
  EXPECT_EQ(thrown_light(greys, camera, {everywhere}, down)[0][0], 0.0);
}

}  // namespace
}  // namespace hada
