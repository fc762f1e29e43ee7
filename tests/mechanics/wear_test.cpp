#include "mechanics/wear.h"

#include <array>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "synth/leg.h"

namespace hada {
namespace {

const Body& leg() {
  static const Body body(leg_mesh());
  return body;
}

TEST(Wear, SlidesUntilNothingPullsAlongTheLeg) {
  const auto knit = worn(leg(), {.courses = 40, .wales = 36});
  EXPECT_TRUE(knit.settled);
  EXPECT_LT(knit.sliding, 1e-4);
  EXPECT_EQ(knit.slack, 0);
  for (std::size_t i = 0; i < knit.places.size(); ++i) {
    EXPECT_NEAR(leg().tree().closest(knit.places[i]).distance, 0.0, 1e-9);
    EXPECT_GT(knit.area_mm2[i], 0.0);
  }
}

TEST(Wear, PressesATubeByTensionOverRadius) {
  LegShape shape;
  shape.ankle_mm = shape.calf_mm = shape.knee_mm = shape.thigh_mm = 300.0;
  shape.bend_mm = 0.0;
  TriangleMesh mesh = leg_mesh(shape);
  const double radius = 150.0 / std::numbers::pi;
  for (auto& v : mesh.vertices_mm) {
    const double r = std::hypot(v.x(), v.z());
    if (r > 0.0) v.x() *= radius / r, v.z() *= radius / r;
  }
  const Body tube(mesh);
  const auto knit = worn(tube, {.courses = 21, .wales = 60, .repeat = {0}});
  const double length = 2.0 * radius * std::sin(std::numbers::pi / 60.0);
  const double tension = length - knit.net.wale_length;
  const double press = 1.2 * tension * 2.0 * std::sin(std::numbers::pi / 60.0);
  // The smooth surface of 96 facets lies within 1e-5 of the tube's radius.
  for (int i = 5 * 60; i < 16 * 60; ++i) {
    EXPECT_NEAR(knit.press[std::size_t(i)], press, 0.01 * press);
  }
}

TEST(Wear, MovesLessTheMoreFrictionHoldsIt) {
  LegShape cone;  // without hollows: the knit presses on it everywhere
  cone.calf_mm = 318.9, cone.knee_mm = 391.5, cone.bend_mm = 0.0;
  const Body body(leg_mesh(cone));
  const auto drawn = [&](double friction) {
    return worn(body, {.courses = 20, .wales = 24, .friction = friction});
  };
  const auto stuck = drawn(1e6), half = drawn(0.1), free = drawn(0.0);
  EXPECT_LE(stuck.steps, 3);  // but for places without press
  EXPECT_TRUE(half.settled);
  const auto moved = [&](const WornKnit& knit) {
    double sum = 0.0;
    for (std::size_t i = 0; i < knit.places.size(); ++i) {
      sum += (knit.places[i] - stuck.places[i]).norm();
    }
    return sum;
  };
  EXPECT_LT(moved(half), moved(free));
  EXPECT_GT(moved(half), 0.0);
}

TEST(Wear, StaysOnABodyOfTwelveTriangles) {
  TriangleMesh cube;
  for (const int i : {0, 1, 2, 3, 4, 5, 6, 7}) {
    cube.vertices_mm.emplace_back(i / 4 * 2 - 1, i / 2 % 2 * 2 - 1, i % 2 * 2 - 1);
  }
  for (const auto& q : {std::array{0, 1, 3, 2},
                        {4, 6, 7, 5},
                        {0, 4, 5, 1},
                        {2, 3, 7, 6},
                        {0, 2, 6, 4},
                        {1, 5, 7, 3}}) {
    cube.triangles.push_back({q[0], q[1], q[2]});
    cube.triangles.push_back({q[0], q[2], q[3]});
  }
  // Its edges are no smooth surface: the knit may not settle, but it stays on the cube.
  const auto knit = worn(Body(cube), {.courses = 12, .wales = 20, .axis = 0, .most_steps = 20});
  for (const auto& place : knit.places) {
    EXPECT_NEAR(place.cwiseAbs().maxCoeff(), 1.0, 1e-12);
  }
}

TEST(Wear, RefusesWhatItCannotBeDrawnOver) {
  EXPECT_THROW(worn(leg(), {.from_mm = 500.0, .to_mm = 100.0}), Error);
  EXPECT_THROW(worn(leg(), {.from_mm = 100.0, .to_mm = 900.0}), Error);
  EXPECT_THROW(worn(leg(), {.courses = 2}), Error);
  const Body sheet(
      TriangleMesh{{{0, 0, 0}, {0, 9, 0}, {9, 0, 0}, {9, 9, 0}}, {{0, 1, 2}, {1, 3, 2}}, {}});
  EXPECT_THROW(worn(sheet), Error);
}

}  // namespace
}  // namespace hada
