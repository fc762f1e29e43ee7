#include "synth/knit.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "synth/knit_loops.h"

namespace hada {
namespace {

TEST(Knit, CountsStitchesAsTheyLie) {
  for (const double gradient : {-0.02, -1e-7, 0.0, 1e-5, 0.02}) {
    for (const double count : {-12.0, -0.3, 0.0, 4.0, 15.5}) {
      const double place = place_of(count, 1.3, gradient);
      // Two roundings of a logarithm, or the first term that the series leaves out.
      EXPECT_NEAR(count_at(place, 1.3, gradient), count, 1e-11) << gradient;
    }
    const double step = place_of(5.01, 1.3, gradient) - place_of(4.99, 1.3, gradient);
    const double place = place_of(5.0, 1.3, gradient);
    // The spacing at a place, from a central difference that errs by (gradient step)^2 / 24.
    EXPECT_NEAR(step / 0.02, 1.3 * (1.0 + gradient * place), 1e-7);
  }
}

TEST(Knit, TurnsAndLeansCounterClockwise) {
  Knit<> knit;
  knit.rotation_rad = 0.3;
  knit.skew_rad = 0.1;
  const auto along = fabric_place(knit, 2.0 * std::cos(0.3), 2.0 * std::sin(0.3));
  EXPECT_NEAR(along[0], 2.0, 1e-12);
  EXPECT_NEAR(along[1], 0.0, 1e-12);
  const auto up = fabric_place(knit, -3.0 * std::sin(0.4), 3.0 * std::cos(0.4));
  EXPECT_NEAR(up[0], 0.0, 1e-12);
  EXPECT_NEAR(up[1], 3.0, 1e-12);
}

TEST(Knit, SeesAYarnAsItIsRound) {
  // A straight yarn along the columns, seen where its middle is half way between two rows.
  std::vector<YarnPoint> points;
  for (int k = 0; k < 400; ++k) points.push_back({9.5, 0.1 * k, 1.0, 0});
  const auto maps = seen_from_above(points, 0.5, 20, 40, {0.1, 0.1}, true);
  // Ripples between spheres 0.01 apart: 0.01^2 / (8 * 0.5) of the height.
  EXPECT_NEAR(maps.height(9, 20), 1.0 + std::sqrt(0.25 - 0.05 * 0.05), 3e-5);
  EXPECT_NEAR(maps.normals(6, 20).y(), 0.35 / 0.5, 1e-3);
  EXPECT_EQ(maps.course(4, 20), -1);
  EXPECT_EQ(maps.course(5, 20), 0);
}

TEST(Knit, ShowsYarnOnAPatchOfHardlyAStitch) {
  Knit<> knit;
  knit.wale_mm = 1.0, knit.course_mm = 0.9, knit.yarn_radius_mm = 0.2, knit.loop_depth_mm = 0.2;
  knit.rotation_rad = 0.3, knit.skew_rad = -0.7;  // rounded, its courses would run along its wales
  const Surface surface = surface_of(knit, {.rows = 21, .cols = 24, .pitch = 0.05}, 1);
  double highest = 0.0;
  for (const float z : surface.height) {
    ASSERT_TRUE(std::isfinite(z));
    highest = std::max(highest, double(z));
  }
  EXPECT_GT(highest, 0.05);
}

TEST(Knit, RefusesYarnThatIsWiderThanItsStitches) {
  Knit<> knit;
  knit.yarn_radius_mm = 1000.0;
  EXPECT_THROW(surface_of(knit, {.rows = 64, .cols = 64, .pitch = 0.1}, 1), Error);
}

TEST(Knit, TilesAndShowsItsColours) {
  Knit<> knit;
  knit.wale_mm = 1.6;
  knit.course_mm = 1.3;
  knit.yarn_radius_mm = 0.25;
  knit.loop_depth_mm = 0.2;
  knit.rotation_rad = 0.05;
  knit.colour_repeat = {0.0, 1.0};
  knit.yarns = {{0.5, 0.1, 0.1}, {0.2, 0.6, 0.3}};
  const Extent extent{256, 320, 0.1, Unit::mm};
  const Surface surface = surface_of(knit, extent, 1);
  // Heights over a seam differ as much as those inside: the largest step anywhere is the yarn's
  // own.
  float seam = 0.0f, inside = 0.0f;
  for (int row = 0; row < extent.rows; ++row) {
    seam = std::max(seam, std::abs(surface.height(row, 0) - surface.height(row, extent.cols - 1)));
    for (int col = 1; col < extent.cols; ++col) {
      inside = std::max(inside, std::abs(surface.height(row, col) - surface.height(row, col - 1)));
    }
  }
  EXPECT_LE(seam, inside);
  double red = 0.0, green = 0.0;
  for (std::size_t k = 0; k < surface.height.size(); ++k) {
    red += surface.albedo.planes[0][k] == 0.5f;
    green += surface.albedo.planes[1][k] == 0.6f;
  }
  // Both yarns take the same share, to what the pixels at their borders leave open.
  EXPECT_NEAR(red / green, 1.0, 0.02);
  EXPECT_GT(red + green, 0.6 * double(surface.height.size()));
}

}  // namespace
}  // namespace hada
