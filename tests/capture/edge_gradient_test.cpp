#include "capture/edge_gradient.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(EdgeGradient, IsTheSlopeOfBrightnessOverThatOfBrightThings) {
  // A ramp along both axes: smoothing leaves it as it is, away from the frame.
  Grid<float> ramp(60, 80);
  for (int row = 0; row < 60; ++row) {
    for (int col = 0; col < 80; ++col) ramp(row, col) = float(2 * col + row);
  }
  const Gradient once = gradient_of(ramp);
  const float v = once.v(30, 40);
  EXPECT_GT(v, 0.0f);
  EXPECT_NEAR(once.u(30, 40), 2.0f * v, 1e-5f);
  // 2 col + row reaches 217; L below that lie L^2 / 4 pixels of the corner, 240 of the 4800 for
  // L = 31. On the lattice that is known to the 2 of a step along u.
  EXPECT_NEAR(1.0f / v, 217.0f - 31.0f, 2.5f);
  // However strong the lamp is.
  for (float& value : ramp) value *= 7.0f;
  EXPECT_NEAR(gradient_of(ramp).v(30, 40), v, 1e-5f);
}

TEST(EdgeGradient, IsNothingAlongTheFrameAndOnEvenGround) {
  Grid<float> step(40, 40);
  for (int row = 0; row < 40; ++row) {
    for (int col = 20; col < 40; ++col) step(row, col) = 1.0f;
  }
  const Gradient found = gradient_of(step);
  for (int i = 0; i < 40; ++i) {
    EXPECT_EQ(found.u(0, i), 0.0f);
    EXPECT_EQ(found.u(i, 39), 0.0f);
    EXPECT_NEAR(found.v(i, 20), 0.0f, 1e-6f);
  }
  EXPECT_NEAR(found.u(20, 5), 0.0f, 1e-6f);
  EXPECT_GT(found.u(20, 20), 0.2f);
  for (const float value : gradient_of(Grid<float>(10, 10)).u) EXPECT_EQ(value, 0.0f);
}

}  // namespace
}  // namespace hada
