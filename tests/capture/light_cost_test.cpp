#include "capture/light_cost.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(OutlineCost, KnowsThatWhatIsCloserToTheCameraLooksLarger) {
  // A ball of radius 10 on a table at 0, seen from a height of 500. On a table 5 lower it must be
  // larger and further out to look the same.
  const OutlineCost cost{{50.0, -20.0, 10.0}, 0.1, 500.0};
  double residuals[3];
  const double table = 0.0;
  const double same[3] = {50.0, -20.0, 10.0};
  cost(same, &table, residuals);
  for (const double residual : residuals) EXPECT_NEAR(residual, 0.0, 1e-12);
  const double lower = -5.0;
  // r = 10 s, height -5 + r, s = (500 + 5 - r) / 490: s = 505 / 500.
  const double scale = 505.0 / 500.0;
  const double other[3] = {50.0 * scale, -20.0 * scale, 10.0 * scale};
  cost(other, &lower, residuals);
  for (const double residual : residuals) EXPECT_NEAR(residual, 0.0, 1e-9);
}

TEST(ChromeCost, IsZeroWhereTheMirroredRayMeetsTheLamp) {
  const Eigen::Vector3d center(3.0, 1.0, 5.0);
  const Ray ray{{4.0, 2.5, 0.0}, -Eigen::Vector3d::UnitZ()};
  const auto seen = *mirrored<double>(ray, center, 5.0);
  const Eigen::Vector3d lamp = seen.point + 300.0 * seen.direction;
  const Eigen::Vector3d direction = lamp.normalized();
  const double inverse_distance = 1.0 / lamp.norm();
  const double sigma = 0.001;
  const double table = 0.0;
  const double sphere[3] = {3.0, 1.0, 5.0};
  const ChromeCost cost{ray, Eigen::Vector3d::Zero(), across(direction), &sigma};
  double residuals[2];
  cost(direction.data(), &inverse_distance, &table, sphere, residuals);
  EXPECT_NEAR(residuals[0], 0.0, 1e-9);
  EXPECT_NEAR(residuals[1], 0.0, 1e-9);
}

}  // namespace
}  // namespace hada
