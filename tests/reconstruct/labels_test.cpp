#include "reconstruct/labels.h"

#include <gtest/gtest.h>

#include "scenes.h"

namespace hada {
namespace {

TEST(LabelSamples, SayWhatBecameOfTheLight) {
  const Relief relief = waves(30, 30);
  LightStack stack = pictures_of(relief, ring_of_lights(12), {.noise = 0.002});
  stack.images[2].planes[0](5, 6) *= 0.3f;
  stack.images[3].planes[0](7, 8) += 0.4f;
  stack.samples[4](9, 9) = Sample::saturated;
  const auto labels = label_samples(stack, solve_normals(stack));
  EXPECT_EQ(labels[2](5, 6), Sample::cast_shadow);
  EXPECT_EQ(labels[3](7, 8), Sample::highlight);
  EXPECT_EQ(labels[4](9, 9), Sample::saturated);
  const auto shares = label_shares(labels, stack.mask);
  // 3 of 10800 samples were made wrong, and noise beyond 4 sigma or a twentieth is rarer.
  EXPECT_GT(shares[std::size_t(Sample::lit)], 0.999);
}

TEST(LabelSamples, KnowWhereTheSurfaceLooksAway) {
  const Relief steep = relief_of(20, 20, [](double x, double) {
    return Eigen::Vector3d(std::abs(x) * 1.5, x < 0.0 ? -1.5 : 1.5, 0.0);
  });
  const LightStack stack = pictures_of(steep, ring_of_lights(16));
  const auto labels = label_samples(stack, solve_normals(stack));
  for (std::size_t k = 0; k < 16; ++k) {
    for (std::size_t i = 0; i < stack.mask.size(); ++i) {
      const bool away = steep.normals[i].cast<double>().dot(stack.lights[k].direction) < -1e-3;
      if (away) {
        EXPECT_EQ(labels[k][i], Sample::attached_shadow);
      }
    }
  }
}

}  // namespace
}  // namespace hada
