#include "app/worn_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace hada {
namespace {

// Stitches of 1 x 0.8 mm around a tube so wide that it is nearly flat.
WornKnit tube() {
  WornKnit knit;
  knit.net.courses = 4, knit.net.wales = 100;
  const double radius = 0.5 / std::sin(std::numbers::pi / 100.0);
  for (int i = 0; i < 400; ++i) {
    const double turn = 2.0 * std::numbers::pi * (i % 100) / 100.0;
    knit.normals.emplace_back(std::sin(turn), 0.0, std::cos(turn));
    knit.places.push_back(radius * knit.normals.back() +
                          Eigen::Vector3d(0.0, 0.8 * (i / 100), 0.0));
  }
  return knit;
}

TEST(WornMesh, LaysLoopsThatDoNotTouch) {
  const WornKnit knit = tube();
  const Places first = loop_ring(knit, 1, thickest_loop),
               second = loop_ring(knit, 2, thickest_loop);
  EXPECT_EQ(first.size() % 100, 0u);
  double nearest = 1e9;
  const std::size_t share = first.size() / 100;
  for (std::size_t i = 0; i < 4 * share; ++i) {
    for (std::size_t j = 0; j < 6 * share; ++j) {
      // Places between the points too: pieces are short, and their middles as near as their ends.
      const auto a = 0.5 * (first[i + share] + first[i + share + 1]);
      const auto b = 0.5 * (second[j] + second[j + 1]);
      nearest = std::min({nearest, (first[i + share] - second[j]).norm(), (a - b).norm()});
    }
  }
  EXPECT_GT(nearest, 2.0 * thickest_loop);
}

TEST(WornMesh, ClosesTheTubesOfLoops) {
  const TriangleMesh mesh = loop_mesh(tube(), thickest_loop);
  // A closed tube has every side twice, once each way, and its outside outside.
  std::set<std::pair<int, int>> sides;
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t s = 0; s < 3; ++s) EXPECT_TRUE(sides.insert({t[s], t[(s + 1) % 3]}).second);
    const auto corner = [&](std::size_t s) { return mesh.vertices_mm[std::size_t(t[s])]; };
    volume += corner(0).dot(corner(1).cross(corner(2))) / 6.0;
  }
  for (const auto& [from, to] : sides) EXPECT_TRUE(sides.count({to, from}));
  EXPECT_GT(volume, 0.0);
  for (const auto& v : mesh.vertices_mm) {
    EXPECT_GT(std::hypot(v.x(), v.z()), 0.5 / std::sin(std::numbers::pi / 100.0) - 0.01);
  }
}

}  // namespace
}  // namespace hada
