#include "reconstruct/normals.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "reconstruct/noise.h"
#include "scenes.h"

namespace hada {
namespace {

// Values of pictures are floats (6e-8) that the condition of the lights (below 3) blows up.
constexpr double rounding = 1e-6;

double largest_angle(const Orientation& found, const NormalMap& truth) {
  double most = 0.0;
  for (std::size_t i = 0; i < found.mask.size(); ++i) {
    if (found.mask[i]) most = std::max<double>(most, (found.normals[i] - truth[i]).norm());
  }
  return most;
}

bool is_full(const Mask& mask) {
  return std::all_of(mask.begin(), mask.end(), [](auto inside) { return inside != 0; });
}

TEST(LeastSquaresNormals, ReturnTheReliefAndItsAlbedo) {
  const Relief relief = waves(30, 40);
  const Orientation found = least_squares_normals(pictures_of(relief, ring_of_lights(6)));
  EXPECT_TRUE(is_full(found.mask));
  EXPECT_LT(largest_angle(found, relief.normals), rounding);
  for (const float rho : found.albedo.planes[0]) ASSERT_NEAR(rho, 0.6f, rounding);
  EXPECT_LT(found.relighting_error, rounding);
}

TEST(LeastSquaresNormals, DivideColouredStrengthsOut) {
  const Relief relief = waves(20, 30);
  std::vector<Light> lights = ring_of_lights(5);
  for (std::size_t k = 0; k < lights.size(); ++k) {
    lights[k].strength = Eigen::Vector3d(1.0 + 0.1 * double(k), 1.3 - 0.2 * double(k), 0.7);
  }
  const Eigen::Vector3d albedo(0.7, 0.4, 0.1);
  const Orientation found =
      least_squares_normals(pictures_of(relief, lights, {.albedo = albedo, .channels = 3}));
  EXPECT_LT(largest_angle(found, relief.normals), rounding);
  for (int channel = 0; channel < 3; ++channel) {
    for (const float rho : found.albedo.planes[std::size_t(channel)]) {
      ASSERT_NEAR(rho, albedo[channel], rounding);
    }
  }
}

TEST(LeastSquaresNormals, FollowNearLights) {
  const Relief relief = waves(30, 30);
  std::vector<Light> lights = ring_of_lights(6);
  for (Light& light : lights) light.position = 60.0 * light.direction;
  const Orientation found = least_squares_normals(pictures_of(relief, lights));
  EXPECT_LT(largest_angle(found, relief.normals), rounding);
  for (const float rho : found.albedo.planes[0]) ASSERT_NEAR(rho, 0.6f, rounding);
}

TEST(LeastSquaresNormals, LeaveShadowedAndSaturatedSamplesOut) {
  const Relief relief = waves(30, 40);
  LightStack stack = pictures_of(relief, ring_of_lights(8));
  for (std::size_t i = 0; i < stack.mask.size(); ++i) {
    const auto k = std::size_t(8.0 * uniform(1, std::int64_t(i)));
    stack.images[k].planes[0][i] = 0.0f;
    stack.samples[k][i] = Sample::shadowed;
    stack.images[(k + 3) % 8].planes[0][i] = 1.0f;
    stack.samples[(k + 3) % 8][i] = Sample::saturated;
  }
  const Orientation found = least_squares_normals(stack);
  EXPECT_TRUE(is_full(found.mask));
  EXPECT_LT(largest_angle(found, relief.normals), rounding);
}

TEST(LeastSquaresNormals, GiveUpPixelsThatCannotBeSolved) {
  LightStack stack = pictures_of(waves(10, 10), ring_of_lights(6));
  for (const std::size_t k : {0, 1, 2, 3}) stack.samples[k](2, 3) = Sample::shadowed;  // 2 are left
  for (std::size_t k = 0; k < 6; ++k) {  // what a normal below the horizon would send
    stack.images[k].planes[0](4, 5) = float(-0.5 * stack.lights[k].direction.z());
  }
  stack.mask(7, 7) = 0;
  const Orientation found = least_squares_normals(stack);
  EXPECT_FALSE(found.mask(2, 3));
  EXPECT_FALSE(found.mask(4, 5));
  EXPECT_FALSE(found.mask(7, 7));
  EXPECT_EQ(std::count(found.mask.begin(), found.mask.end(), 0), 3);
}

TEST(LeastSquaresNormals, GiveUpPixelsWhoseLitLightsLieInOnePlane) {
  std::vector<Light> lights = ring_of_lights(4);
  lights[0].direction = Eigen::Vector3d(0.6, 0.0, 0.8);
  lights[1].direction = Eigen::Vector3d(-0.6, 0.0, 0.8);
  lights[2].direction = Eigen::Vector3d(0.0, 0.0, 1.0);
  LightStack stack = pictures_of(waves(5, 5), lights);
  stack.samples[3](2, 2) = Sample::shadowed;
  const Orientation found = least_squares_normals(stack);
  EXPECT_FALSE(found.mask(2, 2));
  EXPECT_EQ(std::count(found.mask.begin(), found.mask.end(), 0), 1);
}

TEST(LeastSquaresNormals, RefuseTwoLights) {
  EXPECT_THROW(least_squares_normals(pictures_of(waves(5, 5), ring_of_lights(2))), Error);
}

TEST(LeastSquaresNormals, RefuseLightsInOnePlaneAndSayWhatToDo) {
  std::vector<Light> lights = ring_of_lights(5);
  for (Light& light : lights) {
    light.direction.y() = 0.01 * light.direction.x();
    light.direction.normalize();
  }
  try {
    least_squares_normals(pictures_of(waves(5, 5), lights));
    FAIL() << "no Error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("one plane"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("another side"), std::string::npos) << error.what();
  }
}

TEST(LeastSquaresNormals, NameTheConditionOfThreeOrthogonalLightsOne) {
  std::vector<Light> lights = ring_of_lights(3);
  for (std::size_t k = 0; k < 3; ++k) {  // a corner of a cube that looks up
    const double azimuth = 2.0 * std::numbers::pi * double(k) / 3.0;
    lights[k].direction = Eigen::Vector3d(std::sqrt(2.0) * std::cos(azimuth),
                                          std::sqrt(2.0) * std::sin(azimuth), 1.0) /
                          std::sqrt(3.0);
  }
  EXPECT_NEAR(least_squares_normals(pictures_of(waves(5, 5), lights)).condition, 1.0, 1e-9);
}

TEST(LeastSquaresNormals, EstimateTheNoiseOfTheSamples) {
  const Orientation found =
      least_squares_normals(pictures_of(waves(100, 100), ring_of_lights(8), {.noise = 0.004}));
  // 10^4 pixels with 5 degrees of freedom: the median is good to 0.5 %, its closed form to 0.1 %.
  EXPECT_NEAR(found.noise, 0.004, 0.02 * 0.004);
}

TEST(LeastSquaresNormals, AssumeTheStatedNoiseForThreeLights) {
  const Orientation found = least_squares_normals(pictures_of(waves(20, 20), ring_of_lights(3)));
  EXPECT_EQ(found.noise, prior_noise);
  EXPECT_GT(found.normal_sigma(10, 10), 0.0f);
}

// The root mean square over pixels and tangent axes of the error, over that of the stated sigma.
double error_over_sigma(const std::vector<Orientation>& found, const NormalMap& truth) {
  double error = 0.0;
  double sigma = 0.0;
  for (const Orientation& one : found) {
    for (std::size_t i = 0; i < truth.size(); ++i) {
      error += 0.5 * double((one.normals[i] - truth[i]).squaredNorm());
      sigma += std::pow(double(one.normal_sigma[i]), 2);
    }
  }
  return std::sqrt(error / sigma);
}

TEST(LeastSquaresNormals, StateTheSigmaThatMonteCarloFinds) {
  const Relief relief = waves(60, 60);
  std::vector<Orientation> found;
  for (Seed seed = 1; seed <= 4; ++seed) {
    found.push_back(least_squares_normals(
        pictures_of(relief, ring_of_lights(6), {.noise = 0.005, .seed = seed})));
  }
  // 4 x 3600 pixels with two axes: the ratio is good to 0.6 %.
  EXPECT_NEAR(error_over_sigma(found, relief.normals), 1.0, 0.03);
}

TEST(LeastSquaresNormals, CarryTheSigmaOfTheLightsToTheNormals) {
  const Relief relief = waves(12, 12);
  constexpr double tilt = 0.01;
  std::vector<Orientation> found;
  for (Seed seed = 1; seed <= 250; ++seed) {
    LightStack stack = pictures_of(relief, ring_of_lights(7), {.noise = 0.003, .seed = seed});
    for (std::size_t k = 0; k < stack.lights.size(); ++k) {
      Eigen::Vector3d& direction = stack.lights[k].direction;
      const Eigen::Vector3d across = direction.unitOrthogonal();
      direction += tilt * gaussian(seed, std::int64_t(k), 1) * across +
                   tilt * gaussian(seed, std::int64_t(k), 2) * direction.cross(across);
      direction.normalize();
      stack.lights[k].direction_sigma = tilt;
    }
    found.push_back(least_squares_normals(stack));
  }
  // 250 rigs of 14 independent errors, which all pixels of a rig share: good to about 3 %.
  EXPECT_NEAR(error_over_sigma(found, relief.normals), 1.0, 0.10);
}

TEST(LeastSquaresNormals, AreLessSureWhereTheModelFails) {
  LightStack stack = pictures_of(waves(60, 60), ring_of_lights(8), {.noise = 0.003});
  for (int row = 0; row < 20; ++row) {
    for (float& value : stack.images[2].planes[0].row(row)) value += 0.2f;  // a sheen
  }
  const Orientation found = least_squares_normals(stack);
  // The sheen leaves 0.04 (1 - 3/8) over 5 degrees of freedom: 0.07 instead of 0.003, less the
  // hold of the typical noise; tilts of the relief change the gain by some ten per cent.
  EXPECT_GT(found.normal_sigma(8, 30), 10.0f * found.normal_sigma(45, 30));
}

TEST(LeastSquaresNormals, CountShadowsOnlyWhereThePlainMethodIsAskedFor) {
  const Relief relief = waves(20, 20);
  LightStack stack = pictures_of(relief, ring_of_lights(6));
  stack.images[1].planes[0](9, 9) = 0.0f;
  stack.samples[1](9, 9) = Sample::shadowed;
  const auto turned = [&](Estimator estimator) {
    const auto found = least_squares_normals(stack, estimator);
    return (found.normals(9, 9) - relief.normals(9, 9)).norm();
  };
  EXPECT_LT(turned(Estimator::lit_least_squares), 1e-5f);
  // A sample of about 0.6 that is taken for 0 moves rho n by 0.6 |N^+ e| > 0.1.
  EXPECT_GT(turned(Estimator::least_squares), 0.05f);
}

TEST(LeastSquaresNormals, GiveTheSameBytesAtAnyThreadCount) {
  const LightStack stack =
      pictures_of(waves(51, 40), ring_of_lights(5), {.channels = 3, .noise = 0.01});
  set_threads(1);
  const Orientation one = least_squares_normals(stack);
  set_threads(2);
  const Orientation two = least_squares_normals(stack);
  set_threads(0);
  EXPECT_EQ(one.normals, two.normals);
  EXPECT_EQ(one.albedo, two.albedo);
  EXPECT_EQ(one.normal_sigma, two.normal_sigma);
  EXPECT_EQ(one.relighting_error, two.relighting_error);
}

}  // namespace
}  // namespace hada
