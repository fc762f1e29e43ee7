#include "synth/leg.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(Leg, IsClosedAndHasTheGirthsThatWereAsked) {
  const LegShape shape;
  const auto mesh = leg_mesh(shape);
  std::map<std::pair<int, int>, int> sides;
  for (const auto& t : mesh.triangles) {
    for (std::size_t s = 0; s < 3; ++s) ++sides[{t[s], t[(s + 1) % 3]}];
  }
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ((sides.count({side.second, side.first})), 1u);
  }
  const auto girth = [&](int ring) {
    double sum = 0.0;
    for (int s = 0; s < shape.segments; ++s) {
      sum += (mesh.vertices_mm[std::size_t(ring * shape.segments + s)] -
              mesh.vertices_mm[std::size_t(ring * shape.segments + (s + 1) % shape.segments)])
                 .norm();
    }
    return sum;
  };
  // Ellipses whose axes differ by 3 % to both sides are longer by 0.1 %; chords by less.
  EXPECT_NEAR(girth(0), shape.ankle_mm, 0.005 * shape.ankle_mm);
  EXPECT_NEAR(girth(shape.rings), shape.thigh_mm, 0.005 * shape.thigh_mm);
  EXPECT_NEAR(girth(88), shape.knee_mm, 0.01 * shape.knee_mm);
}

TEST(Leg, StandsOnAFootThatIsAsLongAsWasAsked) {
  const auto mesh = leg_mesh({.foot_mm = 230.0});
  std::map<std::pair<int, int>, int> sides;
  double volume = 0.0, behind = 0.0, ahead = 0.0, lowest = 0.0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t s = 0; s < 3; ++s) ++sides[{t[s], t[(s + 1) % 3]}];
    const auto corner = [&](std::size_t s) { return mesh.vertices_mm[std::size_t(t[s])]; };
    volume += corner(0).dot(corner(1).cross(corner(2))) / 6.0;
  }
  EXPECT_GT(volume, 0.0);
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ((sides.count({side.second, side.first})), 1u);
  }
  for (const auto& v : mesh.vertices_mm) {
    if (v.y() >= 0.0) continue;
    behind = std::min(behind, v.z()), ahead = std::max(ahead, v.z());
    lowest = std::min(lowest, v.y());
  }
  // Its shape is drawn in shares of its length, to a twentieth.
  EXPECT_NEAR(ahead - behind, 230.0, 0.05 * 230.0);
  EXPECT_LT(lowest, -70.0);
}

}  // namespace
}  // namespace hada
