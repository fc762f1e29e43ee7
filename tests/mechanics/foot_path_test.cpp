#include "mechanics/foot_path.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "synth/leg.h"

namespace hada {
namespace {

TEST(FootPath, FindsAnkleHeelAndToesWhereverTheFootPoints) {
  TriangleMesh mesh = leg_mesh({.foot_mm = 230.0});
  const double turn = 0.7;
  for (auto& v : mesh.vertices_mm) {
    v = {std::cos(turn) * v.x() + std::sin(turn) * v.z(), v.y(),
         -std::sin(turn) * v.x() + std::cos(turn) * v.z()};
  }
  const Body body(mesh);
  const FootPath path(body, 1, {});
  EXPECT_NEAR(path.girth_mm(), 210.0, 2.0);
  const Eigen::Vector3d forward(std::sin(turn), 0.0, std::cos(turn));
  EXPECT_NEAR((path.leg(1.0).out - forward).norm(), 0.0, 1e-3);
  // The ankle at 0, but for how finely heights are looked at.
  EXPECT_NEAR(path.leg(1.0).middle.y(), 0.0, 10.0);
  // The heel behind the leg and below it, the tip in front of everything.
  const auto heel = path.place(path.heel(0.4), std::numbers::pi).place;
  EXPECT_LT(heel.dot(forward), -33.0);
  EXPECT_LT(heel.y(), -30.0);
  const auto tip = path.toe(1.0, 0.0).place;
  for (const auto& v : mesh.vertices_mm) {
    if (v.y() < 0.0) {
      EXPECT_LT(v.dot(forward), tip.dot(forward) + 0.5);
    }
  }
  for (const double share : {0.0, 0.3, 1.0}) {
    for (const auto& section : {path.leg(share), path.heel(share), path.foot(share)}) {
      EXPECT_GT(body.depth(section.middle), 5.0);
    }
  }
}

TEST(FootPath, RefusesALegWithoutAFoot) {
  const Body leg(leg_mesh());
  EXPECT_THROW(FootPath(leg, 1, {}), Error);
  const Body body(leg_mesh({.foot_mm = 230.0}));
  EXPECT_THROW(FootPath(body, 1, -50.0), Error);
}

}  // namespace
}  // namespace hada
