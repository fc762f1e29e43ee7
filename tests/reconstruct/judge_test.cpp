#include "reconstruct/judge.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/random.h"
#include "reconstruct/normals.h"

namespace hada {
namespace {

constexpr int side = 24;

// A slanted grey patch under eight lights that are not quite those that the stack names.
LightStack patch(const std::vector<Eigen::Vector3d>& off, double noise, Seed seed) {
  LightStack stack;
  stack.camera.extent = {side, side, 1.0, Unit::px};
  stack.mask = Mask(side, side, 1);
  const Eigen::Vector3d normal = Eigen::Vector3d(0.2, -0.1, 1.0).normalized();
  for (int k = 0; k < 8; ++k) {
    Light light;
    const double azimuth = 2.0 * std::numbers::pi * k / 8.0;
    light.direction =
        Eigen::Vector3d(0.6 * std::cos(azimuth), 0.6 * std::sin(azimuth), 0.8).normalized();
    stack.lights.push_back(light);
    Image image(side, side, 1);
    const double value = 0.7 * normal.dot(light.direction + off[std::size_t(k)]);
    for (std::size_t i = 0; i < image.planes[0].size(); ++i) {
      image.planes[0][i] = float(value + noise * gaussian(seed, k, std::int64_t(i)));
    }
    stack.images.push_back(image);
    stack.samples.emplace_back(side, side, Sample::lit);
  }
  return stack;
}

double sigma_in_the_middle(const LightStack& stack) {
  return solve_normals(stack, {.estimator = Estimator::lit_least_squares})
      .normal_sigma(side / 2, side / 2);
}

TEST(Judge, SaysHowFarLightsThatTurnTogetherTurnTheSurface) {
  const std::vector<Eigen::Vector3d> none(8, Eigen::Vector3d::Zero());
  constexpr double noise = 1e-4;
  LightStack stack = patch(none, noise, 1);
  // All lights turned by half a degree about y turn the normal by as much along one axis of two.
  const double turn = 0.5 * std::numbers::pi / 180.0;
  LightErrorMode mode;
  for (const Light& light : stack.lights) {
    mode.push_back(turn * Eigen::Vector3d::UnitY().cross(light.direction));
  }
  stack.light_errors = {mode};
  for (Light& light : stack.lights) light.direction_sigma = turn / std::sqrt(2.0);
  // The turn of the normal is |y x n| = 0.98 of it; noise adds 1e-4 / 0.7.
  const Eigen::Vector3d normal = Eigen::Vector3d(0.2, -0.1, 1.0).normalized();
  const double expected = turn * Eigen::Vector3d::UnitY().cross(normal).norm() / std::sqrt(2.0);
  EXPECT_NEAR(sigma_in_the_middle(stack), expected, 0.02 * expected);
  // Lights that tilt each for itself mostly cancel.
  stack.light_errors.clear();
  EXPECT_LT(sigma_in_the_middle(stack), 0.6 * expected);
}

TEST(Judge, SeesTheNoiseOfTheSamples) {
  const std::vector<Eigen::Vector3d> none(8, Eigen::Vector3d::Zero());
  constexpr double noise = 0.004;
  const Orientation found =
      solve_normals(patch(none, noise, 2), {.estimator = Estimator::lit_least_squares});
  // 576 pixels of five degrees of freedom: known to 1 / sqrt(2 * 2880), 1.3 %; four times that.
  EXPECT_NEAR(found.noise, noise, 0.055 * noise);
}

}  // namespace
}  // namespace hada
