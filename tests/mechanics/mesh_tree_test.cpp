#include "mechanics/mesh_tree.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

using Eigen::Vector3d;

TriangleMesh scattered(int count) {
  TriangleMesh mesh;
  for (int t = 0; t < count; ++t) {
    const Vector3d at(10.0 * uniform(1, t, 0), 10.0 * uniform(1, t, 1), 10.0 * uniform(1, t, 2));
    for (int c = 0; c < 3; ++c) {
      mesh.vertices_mm.push_back(
          at + Vector3d(gaussian(2, t, c, 0), gaussian(2, t, c, 1), gaussian(2, t, c, 2)));
    }
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

Vector3d place(const TriangleMesh& mesh, int triangle, double u, double v) {
  const auto& t = mesh.triangles[std::size_t(triangle)];
  return (1.0 - u - v) * mesh.vertices_mm[std::size_t(t[0])] +
         u * mesh.vertices_mm[std::size_t(t[1])] + v * mesh.vertices_mm[std::size_t(t[2])];
}

TEST(MeshTree, FindsNothingNearerByTryingAllPlaces) {
  const auto mesh = scattered(60);
  const MeshTree tree(mesh);
  for (int i = 0; i < 40; ++i) {
    const Vector3d p(12.0 * uniform(3, i, 0), 12.0 * uniform(3, i, 1), 12.0 * uniform(3, i, 2));
    const auto found = tree.closest(p, i % 60);
    double best = HUGE_VAL;
    constexpr int steps = 24;
    for (int t = 0; t < 60; ++t) {
      for (int u = 0; u <= steps; ++u) {
        for (int v = 0; u + v <= steps; ++v) {
          best = std::min(best, (place(mesh, t, double(u) / steps, double(v) / steps) - p).norm());
        }
      }
    }
    EXPECT_LE(found.distance, best + 1e-12);
    // The trial places are at most the longest side (6) over 24 from any place.
    EXPECT_GT(found.distance, best - 6.0 / steps);
    EXPECT_NEAR((place(mesh, found.triangle, found.weights[1], found.weights[2]) - p).norm(),
                found.distance, 1e-12);
  }
}

TEST(MeshTree, SendsRaysToTheFirstOfAllTriangles) {
  const auto mesh = scattered(200);
  const MeshTree tree(mesh);
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector3d from(-5.0, 10.0 * uniform(4, i, 0), 10.0 * uniform(4, i, 1));
    const Vector3d way = i % 2 == 0 ? Vector3d(1, 0, 0) : Vector3d(1, 0.3, -0.1);
    const auto found = tree.first_hit(from, way);
    double first = HUGE_VAL;
    for (const auto& t : mesh.triangles) {
      const Vector3d &a = mesh.vertices_mm[std::size_t(t[0])],
                     &b = mesh.vertices_mm[std::size_t(t[1])],
                     &c = mesh.vertices_mm[std::size_t(t[2])];
      Eigen::Matrix3d system;
      system << b - a, c - a, -way;
      const Vector3d x = system.inverse() * (from - a);
      if (x[0] >= 0 && x[1] >= 0 && x[0] + x[1] <= 1 && x[2] >= 0) first = std::min(first, x[2]);
    }
    if (first == HUGE_VAL) {
      EXPECT_EQ(found.triangle, -1);
    } else {
      ++hits;
      EXPECT_NEAR(found.distance, first, 1e-9);
    }
  }
  EXPECT_GT(hits, 50);
}

}  // namespace
}  // namespace hada
