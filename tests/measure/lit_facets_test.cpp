#include "measure/lit_facets.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180.0;
constexpr int lights = 10;

struct Scene {
  Facets facets;
  Surface surface;
  LightStack stack;
  std::vector<Vector2d> slopes;  // that are true
};

// Two planes side by side, lit from a ring; pictures of 12 bits with noise of one part in 200. The
// stack believes lights that are wrong by so much.
Scene scene(double light_error_deg, Seed seed) {
  Scene made;
  const Extent extent{96, 160, 0.5, Unit::mm};
  made.slopes = {{0.25, 0.05}, {-0.2, 0.0}};
  made.facets.label = Grid<int>(extent.rows, extent.cols, 0);
  made.facets.reach_px = 3;
  made.surface.extent = extent;
  made.stack.camera.extent = extent;
  made.stack.mask = full_mask(extent);
  for (int f = 0; f < 2; ++f) {
    // Measured with lights that were wrong: a little too steep.
    made.facets.facets.push_back({1.03 * made.slopes[std::size_t(f)], 1e-3, 5000});
  }
  for (int k = 0; k < lights; ++k) {
    const double azimuth = 2.0 * std::numbers::pi * (k + 0.3 * uniform(seed, k, 1)) / lights;
    const double slant = (k % 2 ? 25.0 : 45.0) * degree;
    Light light;
    light.direction = {std::sin(slant) * std::cos(azimuth), std::sin(slant) * std::sin(azimuth),
                       std::cos(slant)};
    Image image(extent.rows, extent.cols, 1);
    for (int row = 0; row < extent.rows; ++row) {
      for (int col = 0; col < extent.cols; ++col) {
        const int f = col < extent.cols / 2 ? 0 : 1;
        made.facets.label(row, col) = f;
        const Vector2d& s = made.slopes[std::size_t(f)];
        const double shade = Vector3d(-s.x(), -s.y(), 1.0).normalized().dot(light.direction);
        const double noisy = 0.6 * shade + 0.003 * gaussian(seed, k, row, col);
        image.planes[0](row, col) = float(std::round(4095.0 * noisy) / 4095.0);
      }
    }
    const Vector3d about = light.direction.cross(
        Vector3d(gaussian(seed, k, 2), gaussian(seed, k, 3), gaussian(seed, k, 4)));
    light.direction =
        Eigen::AngleAxisd(light_error_deg * degree, about.normalized()) * light.direction;
    light.direction_sigma = light_error_deg * degree;
    made.stack.images.push_back(image);
    made.stack.lights.push_back(light);
    made.stack.samples.emplace_back(extent.rows, extent.cols, Sample::lit);
  }
  return made;
}

double fold_error(const Scene& made, const LitFacets& lit) {
  return fold_between(lit.slopes[0], lit.slopes[1]) - fold_between(made.slopes[0], made.slopes[1]);
}

TEST(LitFacets, OfTrueLightsAreTrue) {
  const Scene made = scene(0.01, 1);
  const LitFacets lit = lit_facets(made.facets, made.surface, made.stack);
  // Facets of 6000 pixels: their brightness is known to 1e-3, as is assumed of any, and strengths
  // to 5e-3; over ten lights slopes to about 3e-3 together.
  EXPECT_NEAR(fold_error(made, lit), 0.0, 0.2 * degree);
}

TEST(LitFacets, CorrectLightsThatAreWrong) {
  double corrected = 0.0, plain = 0.0;
  int within = 0;
  constexpr int runs = 20;
  for (Seed seed = 1; seed <= runs; ++seed) {
    const Scene made = scene(1.0, seed);
    const LitFacets lit = lit_facets(made.facets, made.surface, made.stack);
    const double error = fold_error(made, lit);
    corrected += error * error;
    within += std::abs(error) < 1.645 * fold_sigma(lit, 0, 1);
    // Without: lights so firm that nothing is corrected, and albedo free.
    Scene firm = made;
    for (Light& light : firm.stack.lights) light.direction_sigma = 1e-6;
    const double wrong =
        fold_error(made, lit_facets(firm.facets, firm.surface, firm.stack,
                                    {.strength_sigma = 1e-6, .albedo_sigma = 10.0}));
    plain += wrong * wrong;
  }
  EXPECT_LT(corrected, 0.7 * plain);
  // 90 % of 20, and three standard deviations below: 18 - 3 * 1.3.
  EXPECT_GE(within, 14);
}

TEST(LitFacets, NeedThreePictures) {
  Scene made = scene(0.5, 1);
  const Extent& extent = made.surface.extent;
  for (std::size_t k = 2; k < lights; ++k) {
    made.stack.samples[k] = Grid<Sample>(extent.rows, extent.cols, Sample::shadowed);
  }
  const LitFacets lit = lit_facets(made.facets, made.surface, made.stack);
  EXPECT_GE(lit.dark_facet, 0);
  EXPECT_TRUE(lit.slopes.empty());
}

}  // namespace
}  // namespace hada
