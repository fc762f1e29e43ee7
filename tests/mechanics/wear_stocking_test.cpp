#include "mechanics/wear_stocking.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "core/error.h"
#include "mechanics/foot_path.h"
#include "mechanics/taut_yarn.h"
#include "mechanics/worn_maps.h"
#include "synth/leg.h"

namespace hada {
namespace {

const Body& leg() {
  static const Body body(leg_mesh({.foot_mm = 230.0}));
  return body;
}
const WearOptions options{.courses = 60, .wales = 48};
const WornKnit& stocking() {
  static const WornKnit knit = worn_stocking(leg(), options);
  return knit;
}

// The direction in which a course is thinnest: that of the limb it lies around.
Eigen::Vector3d axis_of(int course) {
  const WornKnit& knit = stocking();
  Places ring;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < knit.places.size(); ++i) {
    if (course_of(knit, int(i)) == course) ring.push_back(knit.places[i]);
  }
  for (const auto& p : ring) middle += p / double(ring.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const auto& p : ring) spread += (p - middle) * (p - middle).transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
}

TEST(WearStocking, ComesToRestOutsideOfTheFoot) {
  const WornKnit& knit = stocking();
  EXPECT_TRUE(knit.settled);
  EXPECT_LT(knit.sliding, 1e-3);
  for (std::size_t i = 0; i < knit.places.size(); ++i) {
    EXPECT_NEAR(leg().tree().closest(knit.places[i]).distance, 0.0, 1e-9);
    EXPECT_GT(knit.area_mm2[i], 0.0);
  }
  EXPECT_GT(penetrating(leg(), knit, straight_lines(knit), 1e-6), 100);
  EXPECT_EQ(penetrating(leg(), knit, taut_yarns(leg(), knit).lines, 1e-6), 0);
}

TEST(WearStocking, TurnsAtTheHeelAsTheBodyDoes) {
  const StockingShape shape = stocking_for(leg(), options);
  const FootPath path(leg(), 1, {});
  Eigen::Vector3d down = axis_of(shape.leg - 1), ahead = axis_of(shape.leg + shape.heel);
  if (down.y() > 0.0) down = -down;
  if (ahead.z() < 0.0) ahead = -ahead;
  // The foot stands at a right angle to the leg. A course may lie askew by half the distance to
  // the next at one side and half of it at the other, over the width of the ankle.
  const double row = (path.leg_mm() + path.foot_mm() + path.toe_mm()) / options.courses;
  const double askew = row * std::numbers::pi / path.girth_mm();
  EXPECT_LT(askew, 0.3);  // or there is nothing to tell
  EXPECT_NEAR(std::acos(down.dot(ahead)), 0.5 * std::numbers::pi, askew);
}

TEST(WearStocking, KeepsItsToesCovered) {
  const WornKnit& knit = stocking();
  const auto tip = knit.places.back();
  for (const auto& v : leg().mesh().vertices_mm) {
    if (v.y() < 0.0) {
      EXPECT_LE(v.z(), tip.z() + 0.5);
    }
  }
  // Its faces are as large as what of the body is below the welt, but for chords.
  double area = 0.0, body = 0.0;
  for (const double a : knit.area_mm2) area += a;
  for (const auto& t : leg().mesh().triangles) {
    const auto corner = [&](std::size_t s) { return leg().mesh().vertices_mm[std::size_t(t[s])]; };
    const double top = knit.places[0].y();
    if (std::max({corner(0).y(), corner(1).y(), corner(2).y()}) > top) continue;
    body += 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
  }
  EXPECT_NEAR(area, body, 0.03 * body);
}

TEST(WearStocking, HasMapsOfEveryStitch) {
  const WornKnit& knit = stocking();
  EXPECT_EQ(densities(knit).size(), knit.places.size());
  const auto pressure = pressures(knit, 2);
  // The calf, away from both ends, is pressed everywhere.
  int pressed = 0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    if (knit.places[i].y() > 200.0 && knit.places[i].y() < 260.0) {
      EXPECT_GT(pressure[i], 0.0);
      ++pressed;
    }
  }
  EXPECT_GT(pressed, options.wales);  // several courses lie there
}

TEST(WearStocking, RefusesALegWithoutAFoot) {
  EXPECT_THROW(worn_stocking(Body(leg_mesh()), options), Error);
  EXPECT_THROW(worn_stocking(leg(), {.wales = 8}), Error);
}

}  // namespace
}  // namespace hada
