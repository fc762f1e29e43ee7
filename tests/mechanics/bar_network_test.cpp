#include "mechanics/bar_network.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hada {
namespace {

using Eigen::Vector3d;

// Two triangles of a unit square that meet along its diagonal.
BarNetwork two_triangles(double angle) {
  BarNetwork network;
  const double diagonal = std::sqrt(2.0);
  network.bars = {{0, 1, 1.0}, {1, 2, 1.0}, {2, 3, 1.0}, {3, 0, 1.0}, {0, 2, diagonal}};
  network.hinges = {{0, 2, 3, 1, angle, 1.0}};
  return network;
}

const std::vector<Vector3d> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(BarNetwork, TurnsAHingeToItsAngle) {
  for (const double angle : {0.3, -1.0, 2.5, -2.0}) {
    const auto relaxed = relax(two_triangles(angle), square, {});
    EXPECT_NEAR(hinge_angle(two_triangles(angle).hinges[0], relaxed.places), angle, 1e-7);
    EXPECT_LT(relaxed.strain, 1e-12);
  }
}

TEST(BarNetwork, LiftsTheWingsOfAValleyTowardsTheViewer) {
  const auto relaxed = relax(two_triangles(1.0), square, {});
  const auto middle = 0.5 * (relaxed.places[0] + relaxed.places[2]);
  const auto wings = 0.5 * (relaxed.places[1] + relaxed.places[3]);
  EXPECT_GT(wings.z(), middle.z());
}

TEST(BarNetwork, SharesStrainAndBendingByStiffness) {
  // A bar of stiffness k1 from a pinned point to a free one and on with k2 to another pinned: it
  // rests where k1 (x - 1) = k2 (3 - x - 1).
  BarNetwork network;
  network.bars = {{0, 1, 1.0, 2.0}, {1, 2, 1.0, 1.0}};
  network.pinned = {true, false, true};
  const auto relaxed =
      relax(network, {{0, 0, 0}, {1.2, 0, 0}, {3, 0, 0}}, {.rigid = false, .tolerance = 1e-13});
  EXPECT_NEAR(relaxed.places[1].x(), 4.0 / 3.0, 1e-9);
}

TEST(BarNetwork, KeepsAFaceFlat) {
  BarNetwork network;
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      network.bars.push_back({i, j, (square[std::size_t(i)] - square[std::size_t(j)]).norm()});
    }
  }
  network.planes = {{0, 1, 2, 3}};
  auto bent = square;
  bent[2].z() = 0.1;
  const auto relaxed = relax(network, bent, {});
  EXPECT_LT(relaxed.planarity, 1e-9);
  EXPECT_LT(relaxed.strain, 1e-9);
}

}  // namespace
}  // namespace hada
