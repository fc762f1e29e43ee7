#include "reconstruct/bounce.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scenes.h"

namespace hada {
namespace {

Bounce bounce_of(const Relief& relief) {
  LightStack stack = pictures_of(relief, ring_of_lights(4));
  for (Image& image : stack.images) {
    for (float& value : image.planes[0]) value = 1.0f;
  }
  Grid<float> height(relief.extent.rows, relief.extent.cols);
  for (std::size_t i = 0; i < height.size(); ++i) height[i] = float(relief.height[i]);
  return gather_bounce(stack, height, relief.normals,
                       Grid<float>(relief.extent.rows, relief.extent.cols, 0.5f));
}

TEST(GatherBounce, IsNothingOnAPlane) {
  const Bounce bounce = bounce_of(
      relief_of(30, 30, [](double x, double) { return Eigen::Vector3d(0.3 * x, 0.3, 0.0); }));
  EXPECT_EQ(bounce.at(0, 15, 15), 0.0f);
}

TEST(GatherBounce, IsTheFormFactorOfTheOtherWallOfATrench) {
  // Two planes of slope 1 that meet at a right angle. An element of one, at distance d from the
  // fold, sees an endless wall of height h under the form factor (1 - d / sqrt(d^2 + h^2)) / 2:
  // 0.467 at 4 px of 60.
  const Bounce bounce = bounce_of(relief_of(121, 121, [](double x, double) {
    return Eigen::Vector3d(std::abs(x), x < 0.0 ? -1.0 : 1.0, 0.0);
  }));
  // The trench ends after 60 px instead of never, 5 % of the azimuths from the fold on; twelve
  // directions and steps of whole pixels are good to as much again.
  EXPECT_NEAR(bounce.at(0, 60, 64), 0.467f, 0.1f * 0.467f);
}

}  // namespace
}  // namespace hada
