#include "capture/lamp_colours.h"

#include <gtest/gtest.h>

#include "capture/ambient.h"
#include "core/error.h"
#include "table_scene.h"

namespace hada {
namespace {

const Eigen::Vector3d red(1.3, 0.8, 0.5), blue(0.7, 0.9, 1.2);

// A table with a sheet of two colours under red and blue lamps, in turn.
Photographs coloured_table(const TableSphere& sphere) {
  auto rig = table_rig({sphere});
  for (std::size_t k = 0; k < rig.lights.size(); ++k) {
    Eigen::Vector3d& strength = rig.lights[k].strength;
    strength = strength.cwiseProduct(k % 2 == 0 ? red : blue);
  }
  Surface sheet = waved_sheet(24.0);
  const Extent& extent = sheet.extent;
  sheet.albedo = Image(extent.rows, extent.cols, 3);
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      const bool left = col < extent.cols / 3;
      sheet.albedo.planes[0](row, col) = left ? 0.3f : 0.9f;
      sheet.albedo.planes[1](row, col) = 0.6f;
      sheet.albedo.planes[2](row, col) = left ? 0.8f : 0.4f;
    }
  }
  return photographs_of(photograph(sheet, rig));
}

SphereReading reading_of(const TableSphere& sphere, const Camera& camera) {
  const Eigen::Vector2d at = camera.extent.pixel(sphere.place);
  SphereReading reading;
  reading.sphere = {sphere.kind,
                    {at.y() + 0.5, at.x() + 0.5},
                    0.5 * sphere.diameter_mm / camera.extent.pitch,
                    0.05,
                    {}};
  reading.lights = six_lights();
  for (Light& light : reading.lights) light.direction_sigma = 0.01;
  return reading;
}

// Of a lamp to another: what all have in common is nobody's colour.
void expect_red_and_blue(const std::vector<Eigen::Vector3d>& found, double tolerance) {
  ASSERT_EQ(found.size(), 6u);
  const Eigen::Vector3d truth = red.cwiseQuotient(blue);
  for (std::size_t k = 0; k < found.size(); k += 2) {
    EXPECT_NEAR(grey_of(found[k]), 1.0, 1e-12);
    const Eigen::Vector3d ratio = found[k].cwiseQuotient(found[k + 1]);
    for (int c = 1; c < 3; ++c) {
      EXPECT_NEAR(ratio[c] / ratio[0] / (truth[c] / truth[0]), 1.0, tolerance);
    }
  }
}

TEST(LampColours, AreReadOffAMatteSphere) {
  const auto ball = matte_at(-18.0, 0.0);
  const Photographs photographs = coloured_table(ball);
  SphereReading reading = reading_of(ball, photographs.camera);
  for (std::size_t k = 0; k < 6; ++k) reading.lights[k].strength = k % 2 == 0 ? red : blue;
  expect_red_and_blue(lamp_colours(photographs, {reading}), 1e-12);
  reading.lights[2].strength[1] = 0.0;
  EXPECT_THROW(lamp_colours(photographs, {reading}), Error);
}

TEST(LampColours, AreToldByTheFrameWithoutAMatteSphere) {
  const auto mirror = chrome_at(-18.0, 0.0);
  const Photographs photographs = coloured_table(mirror);
  // Noise of 0.3 % of a value in each of some thousand pixels.
  expect_red_and_blue(lamp_colours(photographs, {reading_of(mirror, photographs.camera)}), 5e-4);
}

TEST(LampColours, OfGreyPicturesAreWhite) {
  const auto ball = matte_at(-18.0, 0.0);
  const Photographs photographs = table_scene({ball});
  for (const auto& colour : lamp_colours(photographs, {reading_of(ball, photographs.camera)})) {
    EXPECT_EQ(colour, Eigen::Vector3d(1.0, 1.0, 1.0));
  }
}

}  // namespace
}  // namespace hada
