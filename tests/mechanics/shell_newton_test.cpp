#include "mechanics/shell_newton.h"

#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"
#include "mechanics/stocking.h"

namespace hada {
namespace {

TEST(ShellNewton, SolvesForTheWayThatChangesForcesSo) {
  ShellNet net = stocking_net({.wales = 24, .leg = 8, .heel = 6, .foot = 4, .toe = 5});
  net.stiffness = stiffness_of_courses(net.course.back() + 1, 10.0);
  net.pinned.assign(net.course.size(), false);
  for (std::size_t i = 0; i < 24; ++i) net.pinned[i] = true;
  net.pinned.back() = true;
  Places places, load;
  for (int i = 0; i < net.points(); ++i) {
    const double turn = 2.0 * std::numbers::pi * net.wale[std::size_t(i)] / 24.0;
    places.emplace_back(8.0 * std::sin(turn), 2.0 * net.course[std::size_t(i)],
                        8.0 * std::cos(turn));
    load.emplace_back(gaussian(1, i, 0), gaussian(1, i, 1), gaussian(1, i, 2));
    if (net.is_pinned(i)) load.back().setZero();
  }
  const auto springs = springs_of(net, places);
  const KnitFrames frames{3, {places.size(), Eigen::Matrix3d(Eigen::Matrix3d::Identity())}};
  ShellNewton newton;
  const Places way = newton.step(net, springs, frames, load, 1e-9);
  const Places change = force_changes(net, springs, way);
  for (int i = 0; i < net.points(); ++i) {
    const auto p = std::size_t(i);
    if (net.is_pinned(i)) {
      EXPECT_EQ(way[p], Eigen::Vector3d(0, 0, 0));
    } else {
      EXPECT_NEAR((change[p] - load[p]).norm(), 0.0, 1e-6);
    }
  }
}

}  // namespace
}  // namespace hada
