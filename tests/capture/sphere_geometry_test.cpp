#include "capture/sphere_geometry.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

Camera camera_of(Camera::Model model) {
  return {.extent = {600, 800, 0.3, Unit::mm}, .model = model, .focal_px = 3000.0};
}

TEST(SphereGeometry, NormalAtTheMiddleOfAnOrthographicSphereFacesTheCamera) {
  const SphereInSpace sphere{{30.0, -20.0, 10.0}, 10.0};
  const Camera camera = camera_of(Camera::Model::orthographic);
  const Eigen::Vector2d middle = camera.project(sphere.center);
  const auto normal = sphere.normal_at(camera, middle.x(), middle.y());
  ASSERT_TRUE(normal.has_value());
  EXPECT_LT((*normal - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
}

TEST(SphereGeometry, NormalsAreWhereTheyWerePutInBothCameras) {
  for (const auto model : {Camera::Model::orthographic, Camera::Model::perspective}) {
    const Camera camera = camera_of(model);
    const SphereInSpace sphere{{-60.0, 45.0, 12.0}, 12.0};
    const Eigen::Vector3d normal = Eigen::Vector3d(0.3, -0.4, 0.8).normalized();
    const Eigen::Vector2d seen = camera.project(sphere.center + 12.0 * normal);
    const auto found = sphere.normal_at(camera, seen.x(), seen.y());
    ASSERT_TRUE(found.has_value());
    EXPECT_LT((*found - normal).norm(), 1e-9);
  }
}

TEST(SphereGeometry, RaysBesideTheSphereMeetNothing) {
  const SphereInSpace sphere{{0.0, 0.0, 10.0}, 10.0};
  EXPECT_FALSE(sphere.normal_at(camera_of(Camera::Model::orthographic), 5.0, 5.0).has_value());
}

TEST(SphereGeometry, OutlineEnclosesExactlyTheRaysThatMeetThePerspectiveSphere) {
  const Camera camera = camera_of(Camera::Model::perspective);
  const SphereInSpace sphere{{-80.0, 50.0, 15.0}, 15.0};
  const Sphere seen = outline(sphere, camera);
  double area = 0.0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  constexpr double step = 0.2;
  for (double v = 0.5 * step; v < 600.0; v += step) {
    for (double u = 0.5 * step; u < 400.0; u += step) {
      if (!sphere.normal_at(camera, u, v)) continue;
      area += step * step;
      sum += step * step * Eigen::Vector2d(u, v);
    }
  }
  // A disc counted in cells of side h has its area off by less than about h sqrt(perimeter h).
  EXPECT_NEAR(std::sqrt(area / 3.14159265), seen.radius_px, 0.01);
  EXPECT_LT((sum / area - seen.center_px).norm(), 0.01);
}

TEST(SphereGeometry, InSpaceIsTheInverseOfOutline) {
  for (const auto model : {Camera::Model::orthographic, Camera::Model::perspective}) {
    const Camera camera = camera_of(model);
    const SphereInSpace sphere{{70.0, -55.0, 14.0}, 14.0};
    const SphereInSpace back = in_space(outline(sphere, camera), camera);
    EXPECT_LT((back.center - sphere.center).norm(), 1e-9);
    EXPECT_NEAR(back.radius, sphere.radius, 1e-9);
  }
}

}  // namespace
}  // namespace hada
