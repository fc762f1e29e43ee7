#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "reconstruct/noise.h"
#include "reconstruct/normals.h"
#include "scenes.h"

// How sure `solve_normals` says that its normals are.
namespace hada {
namespace {

TEST(NormalSigma, EstimatesTheNoiseOfTheSamples) {
  const Orientation found =
      solve_normals(pictures_of(waves(100, 100), ring_of_lights(8), {.noise = 0.004}));
  // 10^4 pixels with 5 degrees of freedom: the median is good to 0.5 %, its closed form to 0.1 %.
  EXPECT_NEAR(found.noise, 0.004, 0.02 * 0.004);
}

TEST(NormalSigma, AssumesTheStatedNoiseForThreeLights) {
  const Orientation found = solve_normals(pictures_of(waves(20, 20), ring_of_lights(3)));
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

// What the pictures show is not quite where the truth is asked.
const Relief misplaced = waves(80, 80, place_sigma_px);

TEST(NormalSigma, IsWhatMonteCarloFinds) {
  std::vector<Orientation> found;
  for (Seed seed = 1; seed <= 4; ++seed) {
    found.push_back(
        solve_normals(pictures_of(misplaced, ring_of_lights(6), {.noise = 0.005, .seed = seed})));
  }
  // 4 x 6400 pixels with two axes are good to 0.5 %. These pictures hold nothing that the model
  // does not explain: sigma allows for 0.0005 of the albedo, 0.6, beside the noise of 0.005, 0.2 %
  // more.
  EXPECT_NEAR(error_over_sigma(found, waves(80, 80).normals), 1.0, 0.03);
}

TEST(NormalSigma, HoldsTheSigmaOfTheLights) {
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
    found.push_back(solve_normals(stack, {.estimator = Estimator::lit_least_squares}));
  }
  // 250 rigs of 14 independent errors, which all pixels of a rig share: good to about 3 %.
  EXPECT_NEAR(error_over_sigma(found, relief.normals), 1.0, 0.10);
}

TEST(NormalSigma, GrowsWhereTheModelFails) {
  LightStack stack = pictures_of(waves(60, 60), ring_of_lights(8), {.noise = 0.003});
  for (int row = 0; row < 20; ++row) {
    for (float& value : stack.images[2].planes[0].row(row)) value += 0.2f;  // a sheen
  }
  const Orientation found = solve_normals(stack, {.estimator = Estimator::lit_least_squares});
  // The sheen leaves 0.04 (1 - 3/8) over 5 degrees of freedom: 0.07 instead of 0.003, less the
  // hold of the typical noise; tilts of the relief change the gain by some ten per cent.
  EXPECT_GT(found.normal_sigma(8, 30), 10.0f * found.normal_sigma(45, 30));
}

TEST(NormalSigma, HoldsTheTruthInNinetyPerCentIntervals) {
  const Relief relief = waves(80, 80);
  const LightStack clean = pictures_of(misplaced, ring_of_lights(12), {.noise = 0.004, .seed = 9});
  for (const bool spoil : {false, true}) {
    const LightStack stack = spoil ? spoiled(clean, 5) : clean;
    for (const Estimator estimator : {Estimator::biweight, Estimator::adaptive}) {
      const Orientation found = solve_normals(stack, {.estimator = estimator});
      double held = 0.0;
      for (std::size_t i = 0; i < found.mask.size(); ++i) {
        // 90 % of a two-dimensional normal distribution lie within sqrt(-2 ln 0.1) sigma.
        held += (found.normals[i] - relief.normals[i]).norm() < 2.146f * found.normal_sigma[i];
      }
      const double share = held / double(found.mask.size());
      EXPECT_GT(share, 0.85) << name_of(estimator);
      // Samples that are half believed widen the pooled variance: by some ten per cent of sigma.
      EXPECT_LT(share, spoil ? 0.97 : 0.95) << name_of(estimator);
    }
  }
}

TEST(NormalSigma, IsANumberWhateverAnEstimatorBelieves) {
  const Relief relief = waves(60, 60);
  LightStack stack = pictures_of(relief, ring_of_lights(20));
  for (Image& image : stack.images) {
    for (float& value : image.planes[0]) value = std::pow(value, 6.0f);  // far from matte
  }
  for (const Estimator estimator : every_estimator) {
    const Orientation found = solve_normals(stack, {.estimator = estimator});
    for (std::size_t i = 0; i < found.mask.size(); ++i) {
      if (!found.mask[i]) continue;
      EXPECT_GT(found.normal_sigma[i], 0.0f) << name_of(estimator);
      EXPECT_LE(found.normal_sigma[i], 1.5708f) << name_of(estimator);
    }
  }
}

}  // namespace
}  // namespace hada
