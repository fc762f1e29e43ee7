#include "reconstruct/normal_plan.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "reconstruct/normals.h"
#include "scenes.h"

namespace hada {
namespace {

constexpr double noise = 2e-3;

LightStack noisy_pictures() {
  return pictures_of(waves(48, 64), ring_of_lights(8), {.noise = noise});
}

NormalPlan planned(const LightStack& stack, Estimator estimator) {
  return plan_normals(source_of(stack, {.estimator = estimator}), estimator);
}

TEST(NormalPlan, LearnsTheNoiseAndLeavesAMattePictureAsItIs) {
  const NormalPlan plan = planned(noisy_pictures(), Estimator::adaptive);
  EXPECT_FALSE(plan.shared);
  // 3072 pixels with five samples to spare each: their variances scatter by sqrt(2 / 5), a median
  // by 1.25 times the mean of as many; ten deviations, for the line is drawn at one albedo only.
  const double rho = 0.6;
  EXPECT_NEAR((plan.noise.constant + rho * plan.noise.shot) / (noise * noise), 1.0,
              10.0 * 1.25 * std::sqrt(2.0 / 5.0 / 3072.0));
}

TEST(NormalPlan, TakesOffTheCurveOfAMaterial) {
  LightStack stack = noisy_pictures();
  const auto curve = [](double cosine) { return 0.4 * (1.0 - cosine); };
  for (Image& image : stack.images) {
    for (float& grey : image.planes[0])
      grey = float(grey * (1.0 + curve(std::clamp(grey / 0.6, 0.0, 1.0))));
  }
  const NormalPlan plan = planned(stack, Estimator::adaptive);
  EXPECT_TRUE(plan.shared);
  EXPECT_TRUE(plan.terms.curved());
  EXPECT_EQ(plan.terms.bounce, 0.0f);  // nothing says where such light would come from
  // Brighter than a cosine where light grazes, up to what the albedo takes.
  const auto found = [&](double away) {
    return away * (plan.terms.curve[0] + away * (plan.terms.curve[1] + away * plan.terms.curve[2]));
  };
  EXPECT_GT(found(0.6), found(0.2) + 0.5 * (curve(0.4) - curve(0.8)));
}

TEST(NormalPlan, TakesOffNoMoreLightBetweenFoldsThanAnAlbedoSends) {
  // Light that no normal explains, and two stories of where it came from.
  LightStack stack = noisy_pictures();
  Bounce seen;
  seen.rho = Grid<float>(48, 64, 0.6f);
  for (std::size_t k = 0; k < stack.images.size(); ++k) {
    seen.gathered.emplace_back(48, 64);
    for (int row = 0; row < 48; ++row) {
      for (int col = 0; col < 64; ++col) {
        const float thrown =
            0.05f * float(std::pow(std::sin(0.3 * row + 0.2 * col + double(k)), 2));
        seen.gathered[k](row, col) = thrown;
        stack.images[k].planes[0](row, col) += 0.5f * thrown;
      }
    }
  }
  const auto told = [&](float share) {
    Bounce bounce = seen;
    for (auto& grid : bounce.gathered) {
      for (float& value : grid) value *= share;
    }
    return plan_normals(source_of(stack, {.bounce = &bounce}), Estimator::adaptive).terms.bounce;
  };
  EXPECT_GT(told(1.0f), 0.25f);  // shape and curve have their share of it
  EXPECT_EQ(told(0.01f), 0.0f);  // it would take an albedo of 30
}

TEST(NormalPlan, OfLeastSquaresIsTheInverseOfTheLights) {
  const LightStack stack = noisy_pictures();
  const NormalPlan plan = planned(stack, Estimator::least_squares);
  EXPECT_FALSE(plan.shared);
  ASSERT_EQ(plan.pseudo_inverse.size(), 3u * stack.lights.size());
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      double sum = 0.0;
      for (std::size_t k = 0; k < stack.lights.size(); ++k)
        sum += double(plan.pseudo_inverse[std::size_t(a) * stack.lights.size() + k]) *
               stack.lights[k].direction[b];
      EXPECT_NEAR(sum, a == b ? 1.0 : 0.0, 1e-6);  // floats
    }
  }
}

}  // namespace
}  // namespace hada
