#include "capture/evidence.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "capture/calibrate.h"
#include "table_scene.h"

namespace hada {
namespace {

Sphere seen_at(const TableSphere& sphere, const Camera& camera) {
  const Eigen::Vector2d at = camera.extent.pixel(sphere.place);
  return {sphere.kind,
          {at.y() + 0.5, at.x() + 0.5},
          0.5 * sphere.diameter_mm / camera.extent.pitch,
          0.05,
          {}};
}

SphereReading reading_of(const Photographs& photographs, const TableSphere& sphere) {
  SphereReading reading;
  reading.sphere = seen_at(sphere, photographs.camera);
  reading.lights = six_lights();
  reading.highlights_px.resize(6, reading.sphere.center_px);
  for (Light& light : reading.lights) light.direction_sigma = 0.02;
  return reading;
}

const std::vector<Eigen::Vector3d> white_lights(6, Eigen::Vector3d::Ones());

TEST(Evidence, HoldsSquaresOfTheMatteSphereAndOfTheSheet) {
  const auto ball = matte_at(-18.0, 0.0);
  const Photographs photographs = table_scene({ball});
  const Evidence all = evidence(photographs, {reading_of(photographs, ball)}, white_lights);
  ASSERT_EQ(all.matte.size(), 1u);
  EXPECT_TRUE(all.chrome.empty());
  const MatteEvidence& seen = all.matte.front();
  EXPECT_GT(seen.rays.size(), 200u);
  ASSERT_EQ(seen.values.size(), 6u);
  ASSERT_EQ(seen.values[0].size(), seen.rays.size());
  for (const auto& place : seen.places) EXPECT_LT(place.norm(), 0.95);
  EXPECT_GT(all.sheet.points.size(), 200u);
  // The sheet lies 12 mm to the right; its mask may be cut a pixel more on one side.
  EXPECT_NEAR(all.sheet.center.x(), 12.0, 0.2);
  EXPECT_NEAR(all.sheet.center.y(), 0.0, 0.2);
}

TEST(Evidence, DoesNotBelieveWhatIsSaturatedOrInTheShadow) {
  const auto ball = matte_at(-18.0, 0.0);
  Photographs photographs = table_scene({ball});
  const Evidence before = evidence(photographs, {reading_of(photographs, ball)}, white_lights);
  std::fill(photographs.saturated[2].begin(), photographs.saturated[2].end(), 1);
  // The left third of the sheet lies in a shadow in one picture; another picture is dark all over.
  for (int row = 0; row < 200; ++row) {
    for (int col = 0; col < 190; ++col) photographs.images[4].planes[0](row, col) *= 0.01f;
  }
  for (float& value : photographs.images[1].planes[0]) value *= 0.1f;
  const Evidence all = evidence(photographs, {reading_of(photographs, ball)}, white_lights);
  for (const double value : all.matte[0].values[2]) EXPECT_TRUE(std::isnan(value));
  ASSERT_FALSE(all.sheet.values.empty());
  for (std::size_t p = 0; p < all.sheet.values.size(); ++p) {
    EXPECT_TRUE(std::isnan(all.sheet.values[p][2]));
    EXPECT_FALSE(std::isnan(all.sheet.values[p][1]));
    const double from_edge = all.sheet.points[p].x() - 8.0;  // mm; a square is 0.6 mm wide
    if (std::abs(from_edge) > 0.5) {
      EXPECT_EQ(std::isnan(all.sheet.values[p][4]), from_edge < 0.0);
    }
  }
  EXPECT_FALSE(std::isnan(before.sheet.values[0][2]));
}

TEST(Evidence, OfABallAloneHasNoSheet) {
  const auto ball = matte_at(-18.0, 0.0);
  Photographs photographs = table_scene({ball});
  const Sphere sphere = seen_at(ball, photographs.camera);
  photographs.mask = Mask(photographs.camera.extent.rows, photographs.camera.extent.cols, 0);
  for (int row = 0; row < photographs.mask.rows(); ++row) {
    for (int col = 0; col < photographs.mask.cols(); ++col) {
      const Eigen::Vector2d at(col + 0.5, row + 0.5);
      photographs.mask(row, col) = (at - sphere.center_px).norm() < sphere.radius_px;
    }
  }
  EXPECT_TRUE(
      evidence(photographs, {reading_of(photographs, ball)}, white_lights).sheet.points.empty());
}

}  // namespace
}  // namespace hada
