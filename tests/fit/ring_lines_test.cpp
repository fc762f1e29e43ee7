#include "fit/ring_lines.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace hada {
namespace {

GrowthSolid straight() {
  GrowthSolid solid;
  solid.frame.pith = {-2.0, 1.0};
  solid.radii = {3.0, 5.0, 8.0};
  solid.radii_loose = {0.0, 0.0, 0.0};
  solid.covariance = Eigen::MatrixXd::Zero(solid.size(), solid.size());
  for (int k = 0; k < 3; ++k) solid.covariance(solid.radii_at() + k, solid.radii_at() + k) = 0.01;
  return solid;
}

TEST(RingLines, AreCirclesOnAnEndGrain) {
  const GrowthSolid solid = straight();
  const auto stations = ring_lines(solid, Cut{}, {.rows = 300, .cols = 300, .pitch = 0.1});
  std::set<std::size_t> seen;
  for (const RingStation& station : stations) {
    seen.insert(station.ring);
    const Eigen::Vector2d arm = station.place - solid.frame.pith;
    // Between two places of a lattice of 0.4 mm a circle of 3 mm bends by 0.4^2 / (8 * 3).
    EXPECT_NEAR(arm.norm(), solid.radii[station.ring], 0.007);
    EXPECT_GT(station.normal.dot(arm.normalized()), 0.99);
    EXPECT_NEAR(station.slope, 1.0, 1e-6);
    EXPECT_NEAR(station.sigma, 0.1, 1e-9);
  }
  EXPECT_EQ(seen.size(), 3u);
  // All the way round the smallest: a ring is looked for along the axis nearer its normal, so that
  // stations lie a step of 0.4 mm apart, on the diagonal 1.42 of it, and twice that where the axis
  // changes.
  std::vector<double> turns;
  for (const RingStation& station : stations) {
    const Eigen::Vector2d arm = station.place - solid.frame.pith;
    if (station.ring == 0) turns.push_back(std::atan2(arm.y(), arm.x()));
  }
  std::sort(turns.begin(), turns.end());
  turns.push_back(turns.front() + 2.0 * M_PI);
  for (std::size_t i = 1; i < turns.size(); ++i) {
    EXPECT_LT(turns[i] - turns[i - 1], 2.0 * std::sqrt(2.0) * 0.4 / 3.0);
  }
}

TEST(RingLines, AreStraightOnAFaceAlongTheStem) {
  const GrowthSolid solid = straight();
  const Cut face = cut_along({2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});
  for (const RingStation& station :
       ring_lines(solid, face, {.rows = 100, .cols = 160, .pitch = 0.1})) {
    // 4 mm beside the pith, y - 1 is the other side of a right triangle.
    const double off = std::sqrt(std::pow(solid.radii[station.ring], 2) - 16.0);
    EXPECT_NEAR(std::abs(station.place.x() - 1.0), off, 0.02);
    EXPECT_GT(station.ring, 0u);  // the innermost ring does not reach the face
  }
}

}  // namespace
}  // namespace hada
