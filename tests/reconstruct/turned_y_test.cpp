#include "reconstruct/turned_y.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

// Waves at 45 degrees, whose slopes along x and y hang together; `noise` of each slope.
NormalMap waves(int side, double noise, double steepest = 0.2) {
  NormalMap normals(side, side, Eigen::Vector3f::UnitZ());
  for (int row = 0; row < side; ++row) {
    for (int col = 0; col < side; ++col) {
      const double slope = steepest * std::cos(0.1 * (col - row));
      const auto rough = [&](int k) { return noise * (2.0 * uniform(5, row, col, k) - 1.0); };
      normals(row, col) =
          Eigen::Vector3f(float(slope + rough(0)), float(slope + rough(1)), 1.0f).normalized();
    }
  }
  return normals;
}

NormalMap turned(NormalMap normals) {
  for (Eigen::Vector3f& n : normals) n.y() = -n.y();
  return normals;
}

TEST(TurnedY, IsSeenByTheCurl) {
  const Mask mask(80, 80, 1);
  EXPECT_LT(gain_of_turned_y(waves(80, 0.0), mask), 0.1);
  EXPECT_GT(gain_of_turned_y(turned(waves(80, 0.0)), mask), 10.0);
}

TEST(TurnedY, IsSeenThroughNoiseRoundLargerSquares) {
  // Round a square of s steps the slopes of a turned y add up to 0.02 s^2 or so, and noise of
  // sigma to sigma (4 s)^(1/2): 0.06 hides it round one step, but not round four.
  const Mask mask(200, 200, 1);
  EXPECT_LT(gain_of_turned_y(waves(200, 0.1), mask), 1.0 / 8.0);
  EXPECT_GT(gain_of_turned_y(turned(waves(200, 0.1)), mask), 8.0);
}

TEST(TurnedY, IsNotSeenInNoise) {
  const Mask mask(200, 200, 1);
  const double found = gain_of_turned_y(waves(200, 0.5, 0.0), mask);
  EXPECT_GT(found, 0.5);
  EXPECT_LT(found, 2.0);
}

TEST(TurnedY, IsNothingWhereThereIsNothingToSee) {
  EXPECT_EQ(gain_of_turned_y(NormalMap(30, 30, Eigen::Vector3f::UnitZ()), Mask(30, 30, 1)), 1.0);
  EXPECT_EQ(gain_of_turned_y(NormalMap(1, 30, Eigen::Vector3f::UnitZ()), Mask(1, 30, 1)), 1.0);
  EXPECT_EQ(gain_of_turned_y(turned(waves(20, 0.0)), Mask(20, 20, 0)), 1.0);
}

}  // namespace
}  // namespace hada
