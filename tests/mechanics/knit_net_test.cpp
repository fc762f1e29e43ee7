#include "mechanics/knit_net.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

using Eigen::Vector3d;

KnitNet net_of(int courses, int wales, bool round) {
  KnitNet net;
  net.courses = courses, net.wales = wales, net.round = round;
  net.stiffness = stiffness_of_courses(courses, 10.0);
  return net;
}

Places crumpled(const KnitNet& net) {
  Places places;
  for (int i = 0; i < net.points(); ++i) {
    places.emplace_back(1.2 * (i % net.wales) + 0.2 * gaussian(1, i, 0),
                        1.1 * (i / net.wales) + 0.2 * gaussian(1, i, 1), 0.2 * gaussian(1, i, 2));
  }
  return places;
}

TEST(KnitNet, AlternatesTheYarnsOfCourses) {
  EXPECT_EQ(stiffness_of_courses(3, 10.0), (std::vector<double>{1.0, 10.0, 1.0}));
  EXPECT_EQ(stiffness_of_courses(4, 5.0, {0, 1, 1}), (std::vector<double>{1.0, 5.0, 5.0, 1.0}));
}

TEST(KnitNet, PullsByBothForcesOfThePaper) {
  KnitNet net = net_of(2, 3, false);
  // Course 0 of nylon at x = 0, 1.5, 3.5; course 1 straight above at rest length.
  Places places{{0, 0, 0}, {1.5, 0, 0}, {3.5, 0, 0}, {0, 1, 0}, {1.5, 1, 0}, {3.5, 1, 0}};
  const Places f = forces(net, springs_of(net, places));
  // Tensions 0.5 and 1: the first point is pulled by 0.5 + 0.2 * 1, the middle one by 1 - 0.5, the
  // last one back by 1 + 0.2 * 0.5.
  EXPECT_NEAR((f[0] - Vector3d(0.7, 0, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((f[1] - Vector3d(0.5, 0, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((f[2] - Vector3d(-1.1, 0, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(f[3].x(), 7.0, 1e-14);  // support yarn is ten times as stiff
}

TEST(KnitNet, ChangesItsForcesAsTheirDifferencesDo) {
  for (const bool round : {false, true}) {
    const KnitNet net = net_of(4, 5, round);
    const Places places = crumpled(net);
    Places way, ahead = places, behind = places;
    constexpr double h = 1e-6;
    for (int i = 0; i < net.points(); ++i) {
      way.emplace_back(gaussian(2, i, 0), gaussian(2, i, 1), gaussian(2, i, 2));
      ahead[std::size_t(i)] += h * way.back(), behind[std::size_t(i)] -= h * way.back();
    }
    const Places change = force_changes(net, springs_of(net, places), way);
    const Places up = forces(net, springs_of(net, ahead)),
                 down = forces(net, springs_of(net, behind));
    // Rounding 1e-15 * 50 / h = 5e-8 over the curvature's h^2.
    for (std::size_t i = 0; i < change.size(); ++i) {
      EXPECT_LT((change[i] - (up[i] - down[i]) / (2.0 * h)).norm(), 2e-7);
    }
  }
}

TEST(KnitNet, IsLinearInTheYarnCoefficient) {
  KnitNet net = net_of(3, 6, false);
  const KnitSprings springs = springs_of(net, crumpled(net));
  const Places slope = continuity_forces(net, springs), with = forces(net, springs);
  net.continuity = 0.0;
  const Places without = forces(net, springs);
  for (std::size_t i = 0; i < slope.size(); ++i) {
    EXPECT_LT((without[i] + 0.2 * slope[i] - with[i]).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace hada
