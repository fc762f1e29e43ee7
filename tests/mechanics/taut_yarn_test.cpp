#include "mechanics/taut_yarn.h"

#include <gtest/gtest.h>

#include "synth/leg.h"

namespace hada {
namespace {

TEST(TautYarn, LeavesNoYarnInsideTheLeg) {
  const Body body(leg_mesh());
  for (const int count : {30, 90}) {
    const auto knit = worn(body, {.courses = count, .wales = count});
    const auto straight = straight_lines(knit);
    EXPECT_EQ(straight.size(), std::size_t(count * (2 * count - 1)));
    const int before = penetrating(body, knit, straight, 1e-6);
    const auto taut = taut_yarns(body, knit);
    EXPECT_GT(before, int(straight.size()) / 3);
    // What is left is rounding of places of some 1e2 mm, and pieces that were halved 24 times.
    EXPECT_EQ(penetrating(body, knit, taut.lines, 1e-6), 0);
    EXPECT_GE(taut.cut, before);
  }
}

TEST(TautYarn, BridgesAHollow) {
  // A roof turned over: two slopes that meet in a valley along y; closed below by a lid.
  TriangleMesh mesh;
  mesh.vertices_mm = {{-5, 0, 2}, {0, 0, 0}, {5, 0, 2}, {-5, 9, 2},
                      {0, 9, 0},  {5, 9, 2}, {0, 4, -9}};
  mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {0, 3, 6},
                    {3, 4, 6}, {4, 5, 6}, {5, 2, 6}, {2, 1, 6}, {1, 0, 6}};
  const Body body(mesh);
  WornKnit knit;
  knit.net.courses = 1, knit.net.wales = 2;
  for (const double x : {-3.0, 3.0}) {
    const MeshPlace at = body.tree().closest({x, 4.5, 0.4 * 3.0});
    knit.places.push_back(at.place);
    knit.triangles.push_back(at.triangle);
    knit.normals.emplace_back(0, 0, 1);
  }
  EXPECT_EQ(taut_yarns(body, knit).inserted, 0);
}

}  // namespace
}  // namespace hada
