#include "reconstruct/slopes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scenes.h"

namespace hada {
namespace {

TEST(SlopesOf, PointUphillWithYUp) {
  const NormalMap normals(1, 1, Eigen::Vector3f(-0.3f, 0.2f, 1.0f).normalized());
  const Eigen::Vector2f slope = slopes_of(normals, Mask(1, 1, 1))(0, 0);
  EXPECT_NEAR(slope.x(), 0.3f, 1e-6f);
  EXPECT_NEAR(slope.y(), -0.2f, 1e-6f);
}

TEST(SlopesOf, SeesThroughAPinHoleWhatLogDepthDoes) {
  // The plane z = a x + b y + c is seen at place (x, y) of the table where
  // z = (a x + b y + c) / (1 + (a x + b y) / D).
  const double distance = 100.0;
  const Eigen::Vector3d normal = Eigen::Vector3d(-0.3, 0.2, 1.0).normalized();
  const PinHole pin_hole{Eigen::Vector2d::Constant(distance), Eigen::Vector2d(4.0, 9.0)};
  const auto w = [&](double u, double v) {
    const double x = u - 4.0;
    const double y = 9.0 - v;
    const double z = (0.3 * x - 0.2 * y + 5.0) / (1.0 + (0.3 * x - 0.2 * y) / distance);
    return -distance * std::log1p(-z / distance);
  };
  const NormalMap normals(20, 30, normal.cast<float>());
  const SlopeMap slopes = slopes_of(normals, Mask(20, 30, 1), pin_hole);
  constexpr double step = 1e-3;  // its square times the third derivative is far below 1e-7
  EXPECT_NEAR(slopes(3, 25).x(), (w(25.5 + step, 3.5) - w(25.5 - step, 3.5)) / (2 * step), 1e-6);
  EXPECT_NEAR(slopes(3, 25).y(), (w(25.5, 3.5 - step) - w(25.5, 3.5 + step)) / (2 * step), 1e-6);
}

TEST(FarthestOffAxis, IsTheAngleOfTheFarthestCorner) {
  // The centre of the last pixel is 30 px to the right of the axis and 40 px below it.
  const PinHole pin_hole{{50.0, 50.0}, {10.5, 20.5}};
  EXPECT_NEAR(farthest_off_axis_deg(pin_hole, Mask(61, 41, 1)), 45.0, 1e-4);
}

TEST(ShareHidden, CountsNormalsThatNoRayCanMeet) {
  // Each leans 45 degrees to the right. No ray that goes out to the right by more than 45 + 5.7
  // degrees meets it: those through the last three of ten columns.
  const NormalMap normals(3, 10, Eigen::Vector3f(1.0f, 0.0f, 1.0f).normalized());
  const PinHole pin_hole{{5.0, 5.0}, {0.5, 1.5}};
  Mask mask(3, 10, 1);
  EXPECT_NEAR(share_hidden(normals, mask, pin_hole), 0.3, 1e-12);
  for (int row = 0; row < 3; ++row) mask(row, 9) = 0;
  EXPECT_NEAR(share_hidden(normals, mask, pin_hole), 2.0 / 9.0, 1e-12);
}

TEST(PinHoleOf, KeepsTheOpticalAxisWhereThePictureIsCropped) {
  Camera camera{.extent = {.rows = 60, .cols = 80}, .focal_px = 500.0};
  EXPECT_FALSE(pin_hole_of(camera, {3, 7}));
  camera.model = Camera::Model::perspective;
  const auto pin_hole = pin_hole_of(camera, {3, 7});
  EXPECT_EQ(pin_hole->centre_px, Eigen::Vector2d(37.0, 23.0));
  EXPECT_EQ(pin_hole->focal_px, Eigen::Vector2d(500.0, 500.0));
}

}  // namespace
}  // namespace hada
