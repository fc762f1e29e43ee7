#include "capture/photograph.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

Light light_from(double slant, double azimuth) {
  Light light;
  light.direction = {std::sin(slant) * std::cos(azimuth), std::sin(slant) * std::sin(azimuth),
                     std::cos(slant)};
  return light;
}

Surface flat_sheet(int rows, int cols, double pitch, float albedo = 0.6f) {
  Surface sheet;
  sheet.extent = {rows, cols, pitch, Unit::mm};
  sheet.mask = full_mask(sheet.extent);
  sheet.height = Grid<float>(rows, cols);
  sheet.albedo = Image(Grid<float>(rows, cols, albedo));
  return sheet;
}

// 40 x 40 pixels of 0.2 mm over a table; no noise, and no steps of brightness.
Rig plain_rig(std::vector<Light> lights) {
  Rig rig;
  rig.rows = 40;
  rig.cols = 40;
  rig.lights = std::move(lights);
  rig.read_noise = 0.0;
  rig.shot_noise = 0.0;
  rig.bits = 32;
  return rig;
}

TEST(Photograph, ShowsAFlatSheetByTheCosineLaw) {
  const Light light = light_from(40.0 * degree, 1.0);
  const LightStack stack = photograph(flat_sheet(80, 80, 0.05), plain_rig({light}));
  ASSERT_EQ(stack.images.size(), 1u);
  ASSERT_EQ(stack.images[0].channels(), 1);
  // Values are stored as floats: 2^-24 relative, of a value below 1.
  EXPECT_NEAR(stack.images[0].planes[0](20, 20), 0.8 * 0.6 * std::cos(40.0 * degree), 1e-7);
  EXPECT_NEAR(stack.images[0].planes[0](2, 2), 0.8 * 0.02 * std::cos(40.0 * degree), 1e-8);
}

TEST(Photograph, MasksThePixelsThatLieWhollyOnTheSheet) {
  // 81 cells at 4 to a pixel: 20 whole pixels and a quarter of one.
  const LightStack stack = photograph(flat_sheet(81, 80, 0.05), plain_rig({light_from(0.5, 0.0)}));
  int count = 0;
  for (const auto counts : stack.mask) count += counts;
  EXPECT_EQ(count, 20 * 20);
}

TEST(Photograph, GivesThreePlanesUnderColouredLight) {
  Light light = light_from(0.0, 0.0);
  light.strength = {1.1, 1.0, 0.9};
  const LightStack stack = photograph(flat_sheet(80, 80, 0.05), plain_rig({light}));
  ASSERT_EQ(stack.images[0].channels(), 3);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(stack.images[0].planes[std::size_t(c)](20, 20), 0.48 * light.strength[c], 1e-7);
  }
}

TEST(Photograph, AddsAmbientLightInProportionToAlbedo) {
  Rig rig = plain_rig({light_from(0.0, 0.0)});
  rig.ambient = 0.1;
  rig.lights[0].strength = Eigen::Vector3d::Zero();
  const LightStack stack = photograph(flat_sheet(80, 80, 0.05), rig);
  EXPECT_NEAR(stack.images[0].planes[0](20, 20), 0.06, 1e-8);
}

TEST(Photograph, WeakensANearLightByTheSquareOfItsDistance) {
  Light light = light_from(0.0, 0.0);
  light.position = Eigen::Vector3d(0.0, 0.0, 10.0);
  const LightStack stack = photograph(flat_sheet(160, 160, 0.05), plain_rig({light}));
  const Eigen::Vector2d place = stack.extent().place(20, 35);
  // (d^2 / r^2) cos = d^3 / r^3 on the table, averaged over a pixel: curvature times pitch^2 / 24
  // times two axes is below 0.06 * 0.04 / 12 = 2e-4 of it.
  const double fall = std::pow(10.0 / std::hypot(10.0, place.norm()), 3);
  EXPECT_NEAR(stack.images[0].planes[0](20, 35), 0.48 * fall, 1e-4);
}

TEST(Photograph, CastsNoShadowWhereTheLightIsSteeperThanTheSheet) {
  Surface sheet = flat_sheet(120, 120, 0.05);
  for (int row = 0; row < 120; ++row) {
    for (int col = 0; col < 120; ++col) {
      sheet.height(row, col) = float(0.3 * std::sin(0.05 * row) * std::cos(0.04 * col));
    }
  }
  // Slopes up to 0.3 * 0.05 / 0.05 = 0.3; a light 45 degrees high rises by 1.
  Rig rig = plain_rig({light_from(45.0 * degree, 0.7)});
  const LightStack with = photograph(sheet, rig);
  rig.cast_shadows = false;
  const LightStack without = photograph(sheet, rig);
  for (std::size_t i = 0; i < with.mask.size(); ++i) {
    if (with.mask[i]) {
      EXPECT_EQ(with.images[0].planes[0][i], without.images[0].planes[0][i]);
    }
  }
}

TEST(Photograph, DarkensTheLengthOfAShadowBehindAStep) {
  Surface sheet = flat_sheet(160, 160, 0.05);
  for (int row = 0; row < 160; ++row) {
    for (int col = 80; col < 160; ++col) sheet.height(row, col) = 1.0f;
  }
  sheet.normals = NormalMap(160, 160, Eigen::Vector3f::UnitZ());
  // Light from the right, 30 degrees off the vertical: the shadow reaches 1 mm * tan 30.
  const LightStack stack = photograph(sheet, plain_rig({light_from(30.0 * degree, 0.0)}));
  double dark_mm = 0.0;
  for (const float value : stack.images[0].planes[0].row(20)) {
    dark_mm += 0.2 * (1.0 - value / (0.48 * std::cos(30.0 * degree)));
  }
  // The foot of the step is a ramp of one cell, and the ray is sampled once in a cell.
  EXPECT_NEAR(dark_mm, std::tan(30.0 * degree), 2.0 * 0.05);
}

TEST(Photograph, DropsTheShadowOfASphereWhereTheLightSays) {
  Rig rig = plain_rig({light_from(45.0 * degree, 0.0)});
  rig.cols = 80;
  rig.spheres = {{.place = {3.0, 0.0}, .diameter_mm = 2.0}};
  const LightStack stack = photograph(flat_sheet(160, 320, 0.05), rig);
  // The centre, 1 mm above the sheet, is projected 1 mm to the left; the ellipse ends sqrt 2 mm
  // beyond that, at x = 3 - 1 - 1.414 = 0.586.
  const auto value_at = [&](double x_mm) {
    const Eigen::Vector2d pixel = stack.extent().pixel({x_mm, 0.0});
    return stack.images[0].planes[0](int(std::lround(pixel.x())), int(std::lround(pixel.y())));
  };
  EXPECT_GT(value_at(0.586 - 0.2), 0.3);
  EXPECT_EQ(value_at(0.586 + 0.2), 0.0f);
}

TEST(Photograph, MakesAMatteSphereBrightestWhereItFacesTheLight) {
  Rig rig = plain_rig({light_from(30.0 * degree, 2.0)});
  rig.spheres = {{.kind = SphereKind::matte, .diameter_mm = 6.0, .albedo = 0.7}};
  rig.sheet_place = {-3.0, 3.0};
  const LightStack stack = photograph(flat_sheet(4, 4, 0.05), rig);
  const Eigen::Vector2d pixel = stack.extent().pixel(3.0 * stack.lights[0].direction.head<2>());
  const int row = int(std::lround(pixel.x()));
  const int col = int(std::lround(pixel.y()));
  // Half a pixel (0.1 mm) off and averaged over one: the cosine falls by (0.2 / 2.6)^2 at most.
  EXPECT_NEAR(stack.images[0].planes[0](row, col), 0.8 * 0.7, 0.56 * 0.006);
  for (const float value : stack.images[0].planes[0]) EXPECT_LE(value, 0.56f);
}

TEST(Photograph, CoversPixelsAtTheOutlineOfASphereInPart) {
  Rig rig = plain_rig({light_from(0.0, 0.0)});
  rig.spheres = {{.kind = SphereKind::chrome, .diameter_mm = 6.1, .albedo = 0.0}};
  rig.cast_shadows = false;
  const LightStack stack = photograph(flat_sheet(160, 160, 0.05, 1.0f), rig);
  double covered = 0.0;
  for (const float value : stack.images[0].planes[0]) covered += 0.04 * (1.0 - value / 0.8);
  // The area of the circle from sub-cells of 1/80 mm: an error of about half of one at each of the
  // circumference / (1/80 mm) places, in random directions: 0.5 / 80^2 sqrt(pi 6.1 80) = 0.003
  // mm^2.
  EXPECT_NEAR(covered, std::numbers::pi * 3.05 * 3.05, 0.01);
}

TEST(Photograph, PutsTheHighlightOfAChromeSphereWhereTheHalfVectorSays) {
  Rig rig = plain_rig({light_from(40.0 * degree, -2.0)});
  rig.rows = 200;
  rig.cols = 200;
  rig.light_diameter = 0.1;
  rig.spheres = {{.kind = SphereKind::chrome, .diameter_mm = 20.0, .albedo = 0.9}};
  const LightStack stack = photograph(flat_sheet(4, 4, 0.05), rig);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weight = 0.0;
  for (int row = 0; row < 200; ++row) {
    for (int col = 0; col < 200; ++col) {
      const double value = stack.images[0].planes[0](row, col);
      if (value < 0.1) continue;
      sum += value * stack.extent().place(row, col);
      weight += value;
    }
  }
  const Eigen::Vector3d half = (stack.lights[0].direction + Eigen::Vector3d::UnitZ()).normalized();
  // The disc is seen as an oval of radius 10 mm * 0.05 / 2, its middle moved by the curvature of
  // the sphere by radius^2 / 10 mm = 0.006 mm at most; sub-cells of 0.0125 mm add less than that.
  EXPECT_LT((sum / weight - 10.0 * half.head<2>()).norm(), 0.012);
  // All the light of the disc: brightness times the area it is seen in, pi R^2 (d/4)^2 at any tilt.
  // That area is 0.196 mm^2, counted in sub-cells with an error of 0.5 / 80^2 sqrt(2 pi 0.25 80).
  const double area = std::numbers::pi * 0.25 * 0.25;
  EXPECT_NEAR(weight * 0.04, 0.9 * 0.8 / std::pow(std::sin(0.05), 2) * area, 0.02 * 56.5);
}

TEST(Photograph, SaturatesTheHighlightAndSaysSo) {
  Rig rig = plain_rig({light_from(40.0 * degree, 0.0)});
  rig.bits = 8;
  rig.spheres = {{.kind = SphereKind::chrome, .diameter_mm = 6.0}};
  const LightStack stack = photograph(flat_sheet(4, 4, 0.05), rig);
  int saturated = 0;
  for (std::size_t i = 0; i < stack.samples[0].size(); ++i) {
    const bool marked = stack.samples[0][i] == Sample::saturated;
    EXPECT_EQ(marked, stack.images[0].planes[0][i] == 1.0f);
    saturated += marked;
  }
  EXPECT_GE(saturated, 1);
  EXPECT_LE(saturated, 4);
}

TEST(Photograph, ShowsTheSheetInTheChromeSphere) {
  Rig rig = plain_rig({light_from(0.0, 0.0)});
  rig.rows = 100;
  rig.cols = 160;
  rig.sheet_place = {-10.0, 0.0};
  rig.spheres = {
      {.kind = SphereKind::chrome, .place = {8.0, 0.0}, .diameter_mm = 10.0, .albedo = 0.5}};
  const LightStack stack = photograph(flat_sheet(200, 200, 0.05, 1.0f), rig);
  // The normal 60 degrees off the vertical sends the view 30 degrees below the horizon; from
  // x = 8 - 4.33, z = 5 + 2.5 it meets the table at x = 3.67 - 7.5 / tan 30 = -9.3, on the sheet.
  const auto at = [&](double x_mm) {
    const Eigen::Vector2d pixel = stack.extent().pixel({x_mm, 0.0});
    return stack.images[0].planes[0](int(std::lround(pixel.x())), int(std::lround(pixel.y())));
  };
  EXPECT_NEAR(at(8.0 - 4.33), 0.5 * 0.8 * 1.0, 1e-6);
  EXPECT_NEAR(at(8.0 + 4.33), 0.5 * 0.8 * 0.02, 1e-6);  // the other side: the table
}

TEST(Photograph, AddsReadAndShotNoise) {
  Rig rig = plain_rig({light_from(0.0, 0.0), light_from(0.0, 0.0)});
  rig.rows = 100;
  rig.cols = 100;
  rig.read_noise = 0.003;
  rig.shot_noise = 0.004;
  const LightStack stack = photograph(flat_sheet(400, 400, 0.05), rig);
  const double sigma = std::hypot(0.003, 0.004 * std::sqrt(0.48));
  double sum = 0.0;
  double squares = 0.0;
  double products = 0.0;
  for (std::size_t i = 0; i < 10000; ++i) {
    const double first = stack.images[0].planes[0][i] - 0.48;
    const double second = stack.images[1].planes[0][i] - 0.48;
    sum += first;
    squares += first * first;
    products += first * second;
  }
  // Standard errors for 10^4 samples: sigma / 100, sigma / (100 sqrt 2), sigma^2 / 100; four of
  // each.
  EXPECT_NEAR(sum / 1e4, 0.0, 0.04 * sigma);
  EXPECT_NEAR(std::sqrt(squares / 1e4), sigma, 0.04 * sigma / std::numbers::sqrt2);
  EXPECT_NEAR(products / 1e4, 0.0, 0.04 * sigma * sigma);
}

TEST(Photograph, QuantisesToItsBits) {
  Rig rig = plain_rig({light_from(0.3, 0.0)});
  rig.bits = 8;
  const LightStack stack = photograph(flat_sheet(80, 80, 0.05), rig);
  const double steps = 255.0 * stack.images[0].planes[0](20, 20);
  EXPECT_NEAR(steps, std::round(255.0 * 0.48 * std::cos(0.3)), 1e-4);
}

TEST(Photograph, IsTheSameAtAnyNumberOfThreads) {
  Surface sheet = flat_sheet(120, 120, 0.05);
  for (int row = 0; row < 120; ++row) {
    for (int col = 0; col < 120; ++col) sheet.height(row, col) = float(std::sin(0.1 * row * col));
  }
  Rig rig = plain_rig({light_from(0.6, 0.0), light_from(0.9, 2.0)});
  rig.read_noise = 0.01;
  rig.bits = 16;
  rig.spheres = {{.place = {3.0, 1.0}, .diameter_mm = 2.0},
                 {.kind = SphereKind::chrome, .place = {-3.0, 1.0}, .diameter_mm = 2.0}};
  set_threads(1);
  const LightStack one = photograph(sheet, rig);
  set_threads(2);
  const LightStack two = photograph(sheet, rig);
  set_threads(0);
  EXPECT_EQ(one.images, two.images);
  EXPECT_EQ(one.mask, two.mask);
}

TEST(Photograph, RefusesASheetThatDoesNotFit) {
  const Rig rig = plain_rig({light_from(0.3, 0.0)});
  EXPECT_THROW(photograph(flat_sheet(200, 80, 0.05), rig), Error);
  EXPECT_THROW(photograph(flat_sheet(80, 80, 0.07), rig), Error);
  Surface without_unit = flat_sheet(80, 80, 0.05);
  without_unit.extent.unit = Unit::px;
  EXPECT_THROW(photograph(without_unit, rig), Error);
}

TEST(Seen, IsTheMeanOfTheFineSheetOverEachPixel) {
  Surface sheet = flat_sheet(42, 40, 0.05);
  for (int row = 0; row < 42; ++row) {
    for (int col = 0; col < 40; ++col) sheet.height(row, col) = float(0.01 * col);
  }
  const Rig rig = plain_rig({});
  const Surface surface = seen(sheet, rig);
  // 160 fine rows: the sheet begins at 59, its first whole pixel at 60; columns at 60 already.
  EXPECT_EQ(surface.offset_px, Eigen::Vector2i(15, 15));
  EXPECT_EQ(surface.extent, (Extent{10, 10, 0.2, Unit::mm}));
  // Mean of 0.01 (4 c, ..., 4 c + 3), less the mean over all columns; float sums.
  EXPECT_NEAR(surface.height(3, 0), 0.01 * (1.5 - 19.5), 1e-6);
  EXPECT_NEAR(surface.height(3, 9), 0.01 * (37.5 - 19.5), 1e-6);
  EXPECT_NEAR(surface.normals(5, 5).x(), -0.2 / std::hypot(0.2, 1.0), 1e-6);
  EXPECT_NEAR(surface.albedo.planes[0](5, 5), 0.6, 1e-6);
}

}  // namespace
}  // namespace hada
