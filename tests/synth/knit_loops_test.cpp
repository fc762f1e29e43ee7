#include "synth/knit_loops.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

Knit<> thin() {
  Knit<> knit;
  knit.wale_mm = 2.0, knit.course_mm = 1.5;
  knit.yarn_radius_mm = 0.25, knit.loop_depth_mm = 0.2;
  return knit;
}

TEST(KnitLoops, BeginAndEndBetweenWalesWithTheirHeadAbove) {
  const Knit<> knit = thin();
  const auto curve = loop_curve(knit);
  // From foot to foot, the last point one step before the next loop begins.
  EXPECT_NEAR(curve.front()[0], -0.5, 1e-12);
  EXPECT_NEAR(curve.front()[1], -knit.loop_reach, 1e-12);
  EXPECT_NEAR(curve.front()[2], -knit.loop_depth_mm, 1e-12);
  const auto& head = curve[curve.size() / 2];
  const double step = 2.0 * std::acos(-1.0) / double(curve.size());
  EXPECT_NEAR(head[0], 0.0, step);
  EXPECT_NEAR(head[1], knit.loop_reach, knit.loop_reach * step * step);
  double highest = -1.0;
  for (const auto& point : curve) highest = std::max(highest, point[2]);
  EXPECT_NEAR(highest, knit.loop_depth_mm, 4.0 * knit.loop_depth_mm * step * step);
}

TEST(KnitLoops, LieDenselyEnoughForASmoothYarn) {
  const Knit<> knit = thin();
  const auto curve = loop_curve(knit);
  for (std::size_t k = 1; k < curve.size(); ++k) {
    const double x = knit.wale_mm * (curve[k][0] - curve[k - 1][0]);
    const double y = knit.course_mm * (curve[k][1] - curve[k - 1][1]);
    // A quarter of the radius on the average; where the loop runs fastest, pi / 2 times that.
    EXPECT_LT(std::hypot(x, y, curve[k][2] - curve[k - 1][2]), 0.4 * knit.yarn_radius_mm);
  }
}

TEST(KnitLoops, ShowTheNearestYarnAndItsCourse) {
  // Two level yarns, crossing: the higher one hides the other.
  std::vector<YarnPoint> points;
  for (int k = 0; k <= 400; ++k) {
    points.push_back({20.0, 0.1 * k, 0.0, 0});
    points.push_back({0.1 * k, 20.0, 1.0, 1});
  }
  const auto maps = seen_from_above(points, 0.4, 41, 41, {0.1, 0.1}, false);
  EXPECT_EQ(maps.course(20, 20), 1);
  EXPECT_EQ(maps.course(20, 5), 0);
  EXPECT_EQ(maps.course(5, 20), 1);
  EXPECT_EQ(maps.course(5, 5), -1);
  EXPECT_FLOAT_EQ(maps.height(20, 20), 1.4f);
  EXPECT_FLOAT_EQ(maps.height(20, 5), 0.4f);
  EXPECT_FLOAT_EQ(maps.normals(5, 5).z(), 1.0f);
}

TEST(KnitLoops, GoOnBeyondTheSeamOfATorus) {
  const std::vector<YarnPoint> points{{0.0, 0.0, 0.0, 3}};
  const auto torus = seen_from_above(points, 0.25, 20, 20, {0.1, 0.1}, true);
  EXPECT_EQ(torus.course(19, 19), 3);
  EXPECT_EQ(torus.course(2, 18), -1);  // 0.28 away
  const auto sheet = seen_from_above(points, 0.25, 20, 20, {0.1, 0.1}, false);
  EXPECT_EQ(sheet.course(19, 19), -1);
}

TEST(KnitLoops, StandWhereTheLatticeSays) {
  Knit<> knit = thin();
  knit.wale_phase = 0.5;  // the origin lies half a wale to the right of a head
  knit.loop_depth_mm = 0.0;
  const Extent extent{150, 150, 0.02, Unit::mm};
  const auto maps = knit_maps(knit, extent, 1);
  // Heads of course 0 lie at (+-1, 1.2) mm, of the same height as the feet of the next course.
  const Eigen::Vector2d pixel = extent.pixel({1.0, knit.loop_reach * knit.course_mm});
  EXPECT_NEAR(maps.height(int(std::lround(pixel[0])), int(std::lround(pixel[1]))), 0.25, 1e-2);
}

}  // namespace
}  // namespace hada
