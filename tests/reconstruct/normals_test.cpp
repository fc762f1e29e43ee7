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

TEST(SolveNormals, ReturnTheReliefAndItsAlbedo) {
  const Relief relief = waves(30, 40);
  const Orientation found = solve_normals(pictures_of(relief, ring_of_lights(6)));
  EXPECT_TRUE(is_full(found.mask));
  EXPECT_LT(largest_angle(found, relief.normals), rounding);
  for (const float rho : found.albedo.planes[0]) ASSERT_NEAR(rho, 0.6f, rounding);
  EXPECT_LT(found.relighting_error, rounding);
}

TEST(SolveNormals, DivideColouredStrengthsOut) {
  const Relief relief = waves(20, 30);
  std::vector<Light> lights = ring_of_lights(5);
  for (std::size_t k = 0; k < lights.size(); ++k) {
    lights[k].strength = Eigen::Vector3d(1.0 + 0.1 * double(k), 1.3 - 0.2 * double(k), 0.7);
  }
  const Eigen::Vector3d albedo(0.7, 0.4, 0.1);
  const Orientation found =
      solve_normals(pictures_of(relief, lights, {.albedo = albedo, .channels = 3}));
  EXPECT_LT(largest_angle(found, relief.normals), rounding);
  for (int channel = 0; channel < 3; ++channel) {
    for (const float rho : found.albedo.planes[std::size_t(channel)]) {
      ASSERT_NEAR(rho, albedo[channel], rounding);
    }
  }
}

TEST(SolveNormals, FollowNearLights) {
  const Relief relief = waves(30, 30);
  std::vector<Light> lights = ring_of_lights(6);
  for (Light& light : lights) light.position = 60.0 * light.direction;
  const Orientation found = solve_normals(pictures_of(relief, lights));
  EXPECT_LT(largest_angle(found, relief.normals), rounding);
  for (const float rho : found.albedo.planes[0]) ASSERT_NEAR(rho, 0.6f, rounding);
}

TEST(SolveNormals, LeaveShadowedAndSaturatedSamplesOut) {
  const Relief relief = waves(30, 40);
  LightStack stack = pictures_of(relief, ring_of_lights(8));
  for (std::size_t i = 0; i < stack.mask.size(); ++i) {
    const auto k = std::size_t(8.0 * uniform(1, std::int64_t(i)));
    stack.images[k].planes[0][i] = 0.0f;
    stack.samples[k][i] = Sample::shadowed;
    stack.images[(k + 3) % 8].planes[0][i] = 1.0f;
    stack.samples[(k + 3) % 8][i] = Sample::saturated;
  }
  const Orientation found = solve_normals(stack);
  EXPECT_TRUE(is_full(found.mask));
  EXPECT_LT(largest_angle(found, relief.normals), rounding);
}

TEST(SolveNormals, GiveUpPixelsThatCannotBeSolved) {
  LightStack stack = pictures_of(waves(10, 10), ring_of_lights(6));
  for (const std::size_t k : {0, 1, 2, 3}) stack.samples[k](2, 3) = Sample::shadowed;  // 2 are left
  for (std::size_t k = 0; k < 6; ++k) {  // what a normal below the horizon would send
    stack.images[k].planes[0](4, 5) = float(-0.5 * stack.lights[k].direction.z());
  }
  stack.mask(7, 7) = 0;
  const Orientation found = solve_normals(stack);
  EXPECT_FALSE(found.mask(2, 3));
  EXPECT_FALSE(found.mask(4, 5));
  EXPECT_FALSE(found.mask(7, 7));
  EXPECT_EQ(std::count(found.mask.begin(), found.mask.end(), 0), 3);
}

TEST(SolveNormals, GiveUpPixelsWhoseLitLightsLieInOnePlane) {
  std::vector<Light> lights = ring_of_lights(4);
  lights[0].direction = Eigen::Vector3d(0.6, 0.0, 0.8);
  lights[1].direction = Eigen::Vector3d(-0.6, 0.0, 0.8);
  lights[2].direction = Eigen::Vector3d(0.0, 0.0, 1.0);
  LightStack stack = pictures_of(waves(5, 5), lights);
  stack.samples[3](2, 2) = Sample::shadowed;
  const Orientation found = solve_normals(stack);
  EXPECT_FALSE(found.mask(2, 2));
  EXPECT_EQ(std::count(found.mask.begin(), found.mask.end(), 0), 1);
}

TEST(SolveNormals, RefuseTwoLights) {
  EXPECT_THROW(solve_normals(pictures_of(waves(5, 5), ring_of_lights(2))), Error);
}

TEST(SolveNormals, RefuseLightsInOnePlaneAndSayWhatToDo) {
  std::vector<Light> lights = ring_of_lights(5);
  for (Light& light : lights) {
    light.direction.y() = 0.01 * light.direction.x();
    light.direction.normalize();
  }
  try {
    solve_normals(pictures_of(waves(5, 5), lights));
    FAIL() << "no Error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("one plane"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("another side"), std::string::npos) << error.what();
  }
}

TEST(SolveNormals, NameTheConditionOfThreeOrthogonalLightsOne) {
  std::vector<Light> lights = ring_of_lights(3);
  for (std::size_t k = 0; k < 3; ++k) {  // a corner of a cube that looks up
    const double azimuth = 2.0 * std::numbers::pi * double(k) / 3.0;
    lights[k].direction = Eigen::Vector3d(std::sqrt(2.0) * std::cos(azimuth),
                                          std::sqrt(2.0) * std::sin(azimuth), 1.0) /
                          std::sqrt(3.0);
  }
  EXPECT_NEAR(solve_normals(pictures_of(waves(5, 5), lights)).condition, 1.0, 1e-9);
}

TEST(SolveNormals, CountShadowsOnlyWhereThePlainMethodIsAskedFor) {
  const Relief relief = waves(20, 20);
  LightStack stack = pictures_of(relief, ring_of_lights(6));
  stack.images[1].planes[0](9, 9) = 0.0f;
  stack.samples[1](9, 9) = Sample::shadowed;
  const auto turned = [&](Estimator estimator) {
    const auto found = solve_normals(stack, {.estimator = estimator});
    return (found.normals(9, 9) - relief.normals(9, 9)).norm();
  };
  EXPECT_LT(turned(Estimator::lit_least_squares), 1e-5f);
  // A sample of about 0.6 that is taken for 0 moves rho n by 0.6 |N^+ e| > 0.1.
  EXPECT_GT(turned(Estimator::least_squares), 0.05f);
}

TEST(SolveNormals, GiveTheSameBytesAtAnyThreadCount) {
  const LightStack stack =
      pictures_of(waves(51, 40), ring_of_lights(5), {.channels = 3, .noise = 0.01});
  set_threads(1);
  const Orientation one = solve_normals(stack);
  set_threads(2);
  const Orientation two = solve_normals(stack);
  set_threads(0);
  EXPECT_EQ(one.normals, two.normals);
  EXPECT_EQ(one.albedo, two.albedo);
  EXPECT_EQ(one.normal_sigma, two.normal_sigma);
  EXPECT_EQ(one.relighting_error, two.relighting_error);
}

TEST(SolveNormals, RobustEstimatorsFindTheReliefUnderShadowAndHighlight) {
  const Relief relief = waves(40, 40);
  const LightStack stack = spoiled(pictures_of(relief, ring_of_lights(16)), 4);
  const auto median_turn = [&](Estimator estimator) {
    const Orientation found = solve_normals(stack, {.estimator = estimator});
    std::vector<float> turns;
    for (std::size_t i = 0; i < found.mask.size(); ++i) {
      turns.push_back((found.normals[i] - relief.normals[i]).norm());
    }
    std::sort(turns.begin(), turns.end());
    return turns[turns.size() / 2];
  };
  // One or two samples of 16 are wrong by half an albedo: least squares turns by some 0.1.
  EXPECT_GT(median_turn(Estimator::least_squares), 0.05f);
  // These reject what is wrong altogether; the scale's floor of 0.002 albedo bounds what is left.
  for (const Estimator estimator : {Estimator::cauchy, Estimator::l1, Estimator::biweight,
                                    Estimator::sparse_bayesian, Estimator::adaptive}) {
    EXPECT_LT(median_turn(estimator), 0.002f) << name_of(estimator);
  }
  // Huber's weights fall to 1.345 s / |r| but not to 0.
  EXPECT_LT(median_turn(Estimator::huber), 0.02f);
  EXPECT_LT(median_turn(Estimator::robust_pca), 0.02f);
}

TEST(SolveNormals, LearnTheShadingCurveOfASurfaceThatIsNotMatte) {
  const Relief relief = waves(60, 60);
  LightStack stack = pictures_of(relief, ring_of_lights(12), {.noise = 0.001});
  for (std::size_t k = 0; k < stack.images.size(); ++k) {
    for (std::size_t i = 0; i < stack.mask.size(); ++i) {
      const double t = double(relief.normals[i].dot(stack.lights[k].direction.cast<float>()));
      stack.images[k].planes[0][i] *= float(1.0 - 0.5 * (1.0 - t) * (1.0 - t));
    }
  }
  const auto mean_turn = [&](Estimator estimator) {
    const Orientation found = solve_normals(stack, {.estimator = estimator});
    double sum = 0.0;
    for (std::size_t i = 0; i < found.mask.size(); ++i) {
      sum += double((found.normals[i] - relief.normals[i]).norm()) / double(found.mask.size());
    }
    return sum;
  };
  // The curve is in the family that is fitted; the errors of the lights that may be are not 0.
  EXPECT_LT(mean_turn(Estimator::adaptive), 0.5 * mean_turn(Estimator::biweight));
}

TEST(SolveNormals, FollowNearLightsToTheHeightOfThePoints) {
  const Relief relief = waves(30, 30);
  std::vector<Light> lights = ring_of_lights(8);
  for (Light& light : lights) light.position = 60.0 * light.direction;
  LightStack stack = pictures_of(relief, lights);
  Grid<float> height(30, 30);
  for (int row = 0; row < 30; ++row) {
    for (int col = 0; col < 30; ++col) {
      const Eigen::Vector2d place = relief.extent.place(row, col);
      height(row, col) = float(relief.height(row, col));
      const Eigen::Vector3d point(place.x(), place.y(), relief.height(row, col));
      for (std::size_t k = 0; k < lights.size(); ++k) {
        stack.images[k].planes[0](row, col) =
            float(0.6 * relief.normals(row, col).cast<double>().dot(arriving(lights[k], 0, point)));
      }
    }
  }
  const auto turn = [&](const Grid<float>* at) {
    return largest_angle(
        solve_normals(stack, {.estimator = Estimator::lit_least_squares, .height = at}),
        relief.normals);
  };
  EXPECT_LT(turn(&height), 2.0 * rounding);
  EXPECT_GT(turn(nullptr), 0.01);  // 3.5 of 60 units off: some 0.05
}

TEST(SolveNormals, FindTheSameBytesInPicturesOnDisk) {
  // More rows than a band.
  const LightStack in_memory =
      pictures_of(waves(150, 90), ring_of_lights(8), {.noise = 0.01, .seed = 3});
  LightStack on_disk = in_memory;
  for (std::size_t k = 0; k < on_disk.images.size(); ++k) {
    Grid<float> plane(150, 90, 0.0f, scratch_files());
    const auto& original = in_memory.images[k].planes[0];
    std::copy(original.begin(), original.end(), plane.begin());
    on_disk.images[k].planes[0] = std::move(plane);
    on_disk.samples[k] = Grid<Sample>(150, 90, Sample::lit, scratch_files());
  }
  for (const Estimator estimator :
       {Estimator::least_squares, Estimator::adaptive, Estimator::robust_pca}) {
    const Orientation expected = solve_normals(in_memory, {.estimator = estimator});
    const Orientation found = solve_normals(on_disk, {.estimator = estimator});
    EXPECT_EQ(found.normals, expected.normals);
    EXPECT_EQ(found.albedo, expected.albedo);
    EXPECT_EQ(found.normal_sigma, expected.normal_sigma);
    EXPECT_EQ(found.mask, expected.mask);
  }
}

}  // namespace
}  // namespace hada
