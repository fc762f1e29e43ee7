#include "reconstruct/judge.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/random.h"
#include "reconstruct/least_squares.h"
#include "reconstruct/noise.h"
#include "reconstruct/normals.h"
#include "tiles.h"

namespace hada {
namespace {

TEST(Judge, TellsWhatTheFitToAllOthersMisses) {
  Tile tile = matte_tile(ring_of_lights(8), 8);
  for (int i = 0; i < tile.pixels; ++i) {
    for (int k = 0; k < 8; ++k) tile.grey[tile.at(k, i)] += 0.02f * float(uniform(5, i, k) - 0.5);
  }
  fit_least_squares(tile);
  Judgement judgement(8, 8);
  std::vector<float> inside(8, 0.0f);
  inside[3] = 1.0f;
  judge(tile, {std::vector<float>(8, 0.0f), {}}, inside, judgement);
  double squares = 0.0;
  for (int k = 0; k < 8; ++k) {
    const auto light = std::size_t(k);
    const Eigen::Vector3d l(tile.x_to[light], tile.y_to[light], tile.z_to[light]);
    const double value = tile.grey[tile.at(k, 3)];
    const double used = value - found_in(tile, 3).dot(l);
    const double missed = value - reference_fit(tile, 3, [&](int j) { return j != k; }).dot(l);
    squares += used * used;
    // Residuals of some 0.005 are differences of floats of about 0.5: 1e-5 of themselves, squared.
    EXPECT_NEAR(judgement.used[light], used * used, 1e-7);
    EXPECT_NEAR(judgement.left_out[light], missed * missed, 1e-7);
    EXPECT_NEAR(judgement.picture[light], value * value, 1e-6);
  }
  EXPECT_NEAR(judgement.squares[3], squares, 1e-7);
  EXPECT_EQ(judgement.freedom[3], 5.0f);
  EXPECT_EQ(judgement.inliers[3], 8.0f);
}

TEST(Judge, CarriesNoiseOnToTheNormalAndTheAlbedo) {
  Tile tile = matte_tile(ring_of_lights(6), 8);
  fit_least_squares(tile);
  Judgement judgement(6, 8);
  judge(tile, {std::vector<float>(6, 0.0f), {}}, std::vector<float>(8, 1.0f), judgement);
  const std::vector<float> matrix = pseudo_inverse_of(tile);
  // The covariance of rho n is N^+ N^+^T for a sample variance of 1.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < 6; ++k) {
    const Eigen::Vector3d column(matrix[k], matrix[6 + k], matrix[12 + k]);
    covariance += column * column.transpose();
  }
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d n = tile_normal(i);
    const double along = n.dot(covariance * n);
    const double rho_squared = tile_rho * tile_rho;
    EXPECT_NEAR(judgement.noise_gain[std::size_t(i)],
                (covariance.trace() - along) / (2.0 * rho_squared), 1e-5);
    EXPECT_NEAR(judgement.albedo_gain[std::size_t(i)], along / rho_squared, 1e-5);
    EXPECT_EQ(judgement.light_variance[std::size_t(i)], 0.0f);
  }
}

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
  // The turn of the normal is |y x n| = 0.98 of it. The share of the albedo that no residual shows
  // adds to it over the sum of the lights' squared components along the axis, 8 * 0.6^2 / 2.
  const Eigen::Vector3d normal = Eigen::Vector3d(0.2, -0.1, 1.0).normalized();
  const double turned = turn * Eigen::Vector3d::UnitY().cross(normal).norm() / std::sqrt(2.0);
  const double expected = std::hypot(turned, double(unexplained_share) / std::sqrt(1.44));
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
