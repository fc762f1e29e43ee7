#include "reconstruct/reconstruct.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "folds.h"
#include "scenes.h"

namespace hada {
namespace {

bool any_says(const std::vector<std::string>& remarks, const std::string& words) {
  return std::any_of(remarks.begin(), remarks.end(), [&](const std::string& remark) {
    return remark.find(words) != std::string::npos;
  });
}

TEST(Reconstruct, ReturnsTheReliefItWasPicturedFrom) {
  const Relief relief = waves(80, 100);
  const Reconstruction found =
      reconstruct(pictures_of(relief, ring_of_lights(8)), {.levelling = Levelling::offset});
  // Trapezoidal steps: z''' / 12 adds up to a change of z'' / 12, and z'' is at most 0.1.
  EXPECT_LT(rms_difference(found.surface.height, relief.height, found.surface.mask), 0.1 / 12.0);
  EXPECT_EQ(found.surface.levelling, "offset");
  // No light goes between these waves, and no picture tells.
  ASSERT_EQ(found.remarks.size(), 1u);
  EXPECT_TRUE(any_says(found.remarks, "cannot be told from their shape"));
}

TEST(Reconstruct, ErrsAsMuchInHeightAsItSays) {
  const Relief relief = waves(80, 100);
  const LightStack clean = pictures_of(relief, ring_of_lights(8));
  const auto truth = reconstruct(clean).surface;
  const auto found = reconstruct(pictures_of(relief, ring_of_lights(8), {.noise = 0.01})).surface;
  double sigma = 0.0;
  for (const float value : found.height_sigma) sigma += double(value) * value;
  sigma = std::sqrt(sigma / double(found.height_sigma.size()));
  const double error = rms_difference(found.height, truth.height, found.mask);
  // A few dozen independent long waves carry most of one picture's error: good to 15 %, twice.
  EXPECT_NEAR(error / sigma, 1.0, 0.3);
}

TEST(Reconstruct, CropsToTheMaskAndRemembersWhere) {
  LightStack stack = pictures_of(waves(40, 60), ring_of_lights(6));
  stack.mask = Mask(40, 60, 0);
  for (int row = 10; row < 30; ++row) {
    for (int col = 25; col < 50; ++col) stack.mask(row, col) = 1;
  }
  stack.camera.extent.pitch = 0.2;
  stack.camera.extent.unit = Unit::mm;
  const Surface surface = reconstruct(stack).surface;
  EXPECT_EQ(surface.extent, (Extent{.rows = 20, .cols = 25, .pitch = 0.2, .unit = Unit::mm}));
  EXPECT_EQ(surface.offset_px, Eigen::Vector2i(25, 10));
  EXPECT_TRUE(surface.mask.same_size(surface.height));
  EXPECT_TRUE(surface.mask.same_size(surface.normals));
  EXPECT_TRUE(surface.mask.same_size(surface.albedo.planes[0]));
  EXPECT_TRUE(surface.mask.same_size(surface.normal_sigma));
  EXPECT_TRUE(surface.mask.same_size(surface.height_sigma));
  EXPECT_EQ(surface.levelling, "plane");
}

TEST(Reconstruct, SaysWhenThereAreFewLights) {
  EXPECT_TRUE(
      any_says(reconstruct(pictures_of(waves(20, 20), ring_of_lights(3))).remarks, "three lights"));
  EXPECT_TRUE(any_says(reconstruct(pictures_of(waves(20, 20), ring_of_lights(4))).remarks,
                       "only 4 lights"));
}

TEST(Reconstruct, SaysWhenLightsLieCloseToOnePlane) {
  std::vector<Light> lights = ring_of_lights(8);
  for (Light& light : lights) {
    light.direction.y() *= 0.1;
    light.direction.normalize();
  }
  EXPECT_TRUE(any_says(reconstruct(pictures_of(waves(20, 20), lights)).remarks, "one plane"));
}

TEST(Reconstruct, SaysWhenManyPixelsAreLost) {
  LightStack stack = pictures_of(waves(20, 20), ring_of_lights(6));
  for (auto& samples : stack.samples) {
    for (int col = 0; col < 10; ++col) samples(5, col) = Sample::saturated;
  }
  const Reconstruction found = reconstruct(stack);
  EXPECT_TRUE(any_says(found.remarks, "2.5 % of the pixels"));
  EXPECT_FALSE(found.surface.mask(5, 3));
}

TEST(Reconstruct, SaysWhenTheSurfaceIsNotMatte) {
  LightStack stack = pictures_of(waves(20, 20), ring_of_lights(6));
  for (float& value : stack.images[1].planes[0]) value += 0.5f;
  EXPECT_TRUE(any_says(reconstruct(stack).remarks, "matte surface"));
}

struct OfNormals {
  double error = 0.0;      // mean, rad
  double within_90 = 0.0;  // share of the pixels that 90 % intervals hold
  double sigma = 0.0;      // mean, rad
};

// Away from the rim: there folds end that are endless in the pictures.
OfNormals of_normals(const Surface& surface, const Relief& relief) {
  const double ninety = std::sqrt(-2.0 * std::log(0.1));  // of two tangent axes
  constexpr int rim = 25;
  OfNormals found;
  double count = 0.0;
  for (int row = rim; row + rim < relief.extent.rows; ++row) {
    for (int col = rim; col + rim < relief.extent.cols; ++col) {
      if (!surface.mask(row, col)) continue;
      const Eigen::Vector3f n = surface.normals(row, col);
      const Eigen::Vector3f truth =
          relief.normals(row + surface.offset_px.y(), col + surface.offset_px.x());
      const double error = std::atan2(double(n.cross(truth).norm()), double(n.dot(truth)));
      found.error += error;
      found.within_90 += error < ninety * double(surface.normal_sigma(row, col));
      found.sigma += double(surface.normal_sigma(row, col));
      count += 1.0;
    }
  }
  return {found.error / count, found.within_90 / count, found.sigma / count};
}

TEST(Reconstruct, TakesLightBetweenFoldsOffAndDoubtsAPartOfIt) {
  for (const Seed seed : {1u, 3u}) {
    const Relief relief = folds(110, 180, 2.0, seed);
    const LightStack stack = pictures_with_bounce(relief, 0.7, seed);
    const Reconstruction found = reconstruct(stack);
    const OfNormals plain =
        of_normals(reconstruct(stack, {.estimator = Estimator::biweight}).surface, relief);
    const OfNormals ours = of_normals(found.surface, relief);
    // Each of three passes leaves a third of the error of the one before: 0.04 in the end, and the
    // strength is told to a tenth.
    EXPECT_LT(ours.error, 0.15 * plain.error);
    // The strips send and receive as the model says, so what is doubted, half, is more than is
    // wrong; and less than all.
    EXPECT_GT(ours.within_90, 0.85);
    EXPECT_LT(ours.sigma, plain.error);
  }
}

TEST(Reconstruct, SaysWhenLightBetweenFoldsCannotBeTold) {
  // Every strip of these folds is lit in every picture: what they throw on each other is then
  // linear in the direction of the light, as the picture of another shape would be.
  const Relief relief = folds(110, 180, 0.9, 2);
  const Reconstruction found = reconstruct(pictures_with_bounce(relief, 0.5, 2));
  EXPECT_TRUE(any_says(found.remarks, "cannot be told from their shape"));
  // And it does turn the normals, by several of their sigmas.
  const OfNormals normals = of_normals(found.surface, relief);
  EXPECT_GT(normals.error, 3.0 * normals.sigma);
}

TEST(Reconstruct, SaysWhenRegionsAreSeparate) {
  LightStack stack = pictures_of(waves(20, 20), ring_of_lights(6));
  for (int row = 0; row < 20; ++row) stack.mask(row, 10) = 0;
  EXPECT_TRUE(any_says(reconstruct(stack).remarks, "2 separate regions"));
}

TEST(Reconstruct, RefusesAnEmptyMaskAndBlackPictures) {
  LightStack stack = pictures_of(waves(10, 10), ring_of_lights(6));
  for (Image& image : stack.images) image = Image(10, 10, 1);
  EXPECT_THROW(reconstruct(stack), Error);
  stack.mask = Mask(10, 10, 0);
  EXPECT_THROW(reconstruct(stack), Error);
}

TEST(Reconstruct, GivesTheSameBytesAtAnyThreadCount) {
  const LightStack stack = pictures_of(waves(41, 40), ring_of_lights(5), {.noise = 0.01});
  set_threads(1);
  const Surface one = reconstruct(stack).surface;
  set_threads(2);
  const Surface two = reconstruct(stack).surface;
  set_threads(0);
  EXPECT_EQ(one.height, two.height);
  EXPECT_EQ(one.height_sigma, two.height_sigma);
  EXPECT_EQ(one.normals, two.normals);
}

}  // namespace
}  // namespace hada
