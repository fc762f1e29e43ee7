#include "mechanics/shell_net.h"

#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"
#include "mechanics/stocking.h"

namespace hada {
namespace {

ShellNet small_stocking(int heel) {
  ShellNet net = stocking_net({.wales = 24, .leg = 8, .heel = heel, .foot = 4, .toe = 5});
  net.stiffness = stiffness_of_courses(net.course.back() + 1, 10.0);
  return net;
}

// Stitches around a tube, all springs taut, each a little aside.
Places around(const ShellNet& net) {
  Places places;
  for (int i = 0; i < net.points(); ++i) {
    const double turn = 2.0 * std::numbers::pi * net.wale[std::size_t(i)] / 24.0;
    places.emplace_back(8.0 * std::sin(turn), 2.0 * net.course[std::size_t(i)],
                        8.0 * std::cos(turn));
    for (int axis = 0; axis < 3; ++axis) places.back()[axis] += 0.2 * gaussian(3, i, axis);
  }
  return places;
}

TEST(ShellNet, PullsAsATubeDoesWhereItIsOne) {
  const ShellNet net = small_stocking(0);
  KnitNet tube;
  tube.courses = 12, tube.wales = 24, tube.round = true;
  tube.stiffness = stiffness_of_courses(12, 10.0);
  Places places = around(net);
  const Places shell = forces(net, springs_of(net, places));
  places.resize(std::size_t(tube.points()));
  const Places knit = forces(tube, springs_of(tube, places));
  // All but the last course of the tube, which hangs on to nothing further.
  for (int i = 0; i < 11 * 24; ++i) {
    EXPECT_NEAR((shell[std::size_t(i)] - knit[std::size_t(i)]).norm(), 0.0, 1e-12);
  }
}

TEST(ShellNet, KnowsHowItsForcesChange) {
  const ShellNet net = small_stocking(6);
  const Places places = around(net);
  Places way, ahead = places, behind = places;
  const double step = 1e-6;
  for (int i = 0; i < net.points(); ++i) {
    way.emplace_back(gaussian(5, i, 0), gaussian(5, i, 1), gaussian(5, i, 2));
    ahead[std::size_t(i)] += step * way.back(), behind[std::size_t(i)] -= step * way.back();
  }
  const Places change = force_changes(net, springs_of(net, places), way);
  const Places after = forces(net, springs_of(net, ahead)),
               before = forces(net, springs_of(net, behind));
  // Forces of some 1e2 are rounded to 1e-14 of it, which the step makes 1e-6.
  for (std::size_t i = 0; i < change.size(); ++i) {
    EXPECT_NEAR(((after[i] - before[i]) / (2.0 * step) - change[i]).norm(), 0.0, 1e-5);
  }
}

TEST(ShellNet, HardlyPushesWhereYarnIsSlack) {
  ShellNet net;
  net.course = {0, 0}, net.wale = {0, 1};
  net.springs = {{0, 1, 0}}, net.along = 1, net.stiffness = {10.0};
  EXPECT_DOUBLE_EQ(springs_of(net, {{0, 0, 0}, {1.5, 0, 0}}).tension[0], 5.0);
  EXPECT_DOUBLE_EQ(springs_of(net, {{0, 0, 0}, {0.5, 0, 0}}).tension[0], -0.05);
}

}  // namespace
}  // namespace hada
