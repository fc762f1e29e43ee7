#include "core/camera.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

Camera camera_of(Camera::Model model) {
  return {{300, 400, 0.26, Unit::mm}, model, 5000.0};
}

// A ray, followed down to any height near the table, is seen where it began.
RC_GTEST_PROP(Camera, ProjectsEveryPointOfARayToItsPixel, (std::uint64_t seed, bool perspective)) {
  const Camera camera =
      camera_of(perspective ? Camera::Model::perspective : Camera::Model::orthographic);
  const double u = 400.0 * uniform(seed, 0);
  const double v = 300.0 * uniform(seed, 1);
  const double z = 100.0 * (uniform(seed, 2) - 0.5);
  const Ray ray = camera.ray(u, v);
  RC_ASSERT(std::abs(ray.direction.norm() - 1.0) < 1e-15);
  const Eigen::Vector3d point =
      ray.origin + (z - ray.origin.z()) / ray.direction.z() * ray.direction;
  const Eigen::Vector2d seen = camera.project(point);
  // Places of 50 mm from 1300 mm away, rounded to 2^-52 a few times, are 1e-11 px at most.
  RC_ASSERT((seen - Eigen::Vector2d(u, v)).norm() < 1e-10);
}

TEST(Camera, LooksStraightDownInTheMiddle) {
  for (const auto model : {Camera::Model::orthographic, Camera::Model::perspective}) {
    const Ray ray = camera_of(model).ray(200.0, 150.0);
    EXPECT_EQ(ray.direction, -Eigen::Vector3d::UnitZ());
    EXPECT_EQ(ray.origin.head<2>().norm(), 0.0);
  }
}

TEST(Camera, PutsTheFirstPixelAtUpperLeft) {
  const Camera camera = camera_of(Camera::Model::orthographic);
  const Eigen::Vector3d first = camera.ray(0.5, 0.5).origin;
  EXPECT_NEAR(first.x(), -199.5 * 0.26, 1e-12);
  EXPECT_NEAR(first.y(), 149.5 * 0.26, 1e-12);
}

TEST(Camera, SpansOnePitchPerPixelOnTheTableAndLessAbove) {
  const Camera camera = camera_of(Camera::Model::perspective);
  const auto pixels_per_mm = [&](double z) {
    return camera.project({1.0, 0.0, z}).x() - camera.project({0.0, 0.0, z}).x();
  };
  EXPECT_NEAR(pixels_per_mm(0.0), 1.0 / 0.26, 1e-10);
  // Half way up to the pin-hole everything looks twice as large.
  EXPECT_NEAR(pixels_per_mm(0.5 * camera.distance()), 2.0 / 0.26, 1e-10);
}

}  // namespace
}  // namespace hada
