#include "mechanics/body.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "synth/leg.h"

namespace hada {
namespace {

using Eigen::Vector3d;

// A tube of radius 10 about y.
TriangleMesh tube() {
  LegShape shape;
  shape.ankle_mm = shape.calf_mm = shape.knee_mm = shape.thigh_mm = 20.0 * M_PI;
  shape.bend_mm = 0.0, shape.length_mm = 100.0;
  TriangleMesh mesh = leg_mesh(shape);
  for (Vector3d& v : mesh.vertices_mm) {
    const double r = std::hypot(v.x(), v.z());
    if (r > 0.0) v.x() *= 10.0 / r, v.z() *= 10.0 / r;
  }
  return mesh;
}

MeshPlace side_of(const Body& body, double turn) {
  return body.tree().closest({10.0 * std::sin(turn), 50.7, 10.0 * std::cos(turn)});
}

TEST(Body, WeldsAndTurnsItsTrianglesOutward) {
  const TriangleMesh whole = tube();
  TriangleMesh loose;  // every triangle with corners of its own, inside out
  for (const auto& t : whole.triangles) {
    const int first = int(loose.vertices_mm.size());
    for (const int v : t) loose.vertices_mm.push_back(whole.vertices_mm[std::size_t(v)]);
    loose.triangles.push_back({first, first + 2, first + 1});
  }
  const Body body(loose);
  EXPECT_EQ(body.mesh().vertices_mm.size(), whole.vertices_mm.size());
  for (const auto& sides : body.neighbours()) {
    for (const int other : sides) EXPECT_GE(other, 0);
  }
  EXPECT_GT(body.normal(side_of(body, 0.0)).z(), 0.99);
}

TEST(Body, IsTurnedOutwardWhereverAnOpenOneLies) {
  TriangleMesh open = tube();
  std::erase_if(open.triangles, [&](const auto& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](int v) { return open.vertices_mm[std::size_t(v)].y() > 99.0; });
  });
  for (const double far : {0.0, 3000.0, -3000.0}) {
    TriangleMesh moved = open;
    for (Vector3d& v : moved.vertices_mm) v.y() += far;
    const Body body(moved);
    EXPECT_GT(body.facet_normal(body.tree().closest({0.0, 50.7 + far, 10.0}).triangle).z(), 0.99);
  }
}

TEST(Body, LaysSliversIntoThePlaneBesideThem) {
  TriangleMesh mesh = tube();
  const auto whole = mesh.triangles;
  // The middle of a long side gets a corner of its own, as in files a little off it.
  for (std::size_t i = 0; i < whole.size(); i += 7) {
    const auto t = whole[i];
    const Vector3d middle =
        0.5 * (mesh.vertices_mm[std::size_t(t[0])] + mesh.vertices_mm[std::size_t(t[1])]);
    const int added = int(mesh.vertices_mm.size());
    mesh.vertices_mm.push_back(middle + Vector3d::Constant(1e-7 * (i % 3 == 0 ? 1.0 : -1.0)));
    mesh.triangles[i] = {added, t[1], t[2]};
    mesh.triangles.push_back({t[0], added, t[2]});
    mesh.triangles.push_back({t[0], t[1], added});  // the sliver
  }
  const Body clean(tube()), slivered(mesh);
  for (int k = 0; k < 200; ++k) {
    const double turn = 0.0314 * k, y = 20.0 + 0.3 * k;
    const Vector3d seen(10.0 * std::sin(turn), y, 10.0 * std::cos(turn));
    const Vector3d a = clean.normal(clean.tree().closest(seen));
    const Vector3d b = slivered.normal(slivered.tree().closest(seen));
    // The corner that was added lies on the facet; its normal is that of the facets around it,
    // which are 0.065 apart.
    EXPECT_LT((a - b).norm(), 0.065) << k;
  }
}

TEST(Body, KnowsTheTubeThatItsFacetsStandFor) {
  const Body body(tube());
  for (const double turn : {0.1, 1.234, 4.0}) {
    const MeshPlace at = side_of(body, turn);
    const Vector3d out(std::sin(turn), 0.0, std::cos(turn));
    // 96 facets: an angle of 0.065 between two; what the parabola misses is of its fourth power.
    EXPECT_LT((body.normal(at) - out).norm(), 1e-3);
    const Vector3d smooth = body.smooth_place(at);
    EXPECT_NEAR(std::hypot(smooth.x(), smooth.z()), 10.0, 1e-4);
    EXPECT_LT(std::hypot(at.place.x(), at.place.z()), 10.0);
    const Eigen::Matrix3d curvature = body.curvature(at);
    const Vector3d around(std::cos(turn), 0.0, -std::sin(turn));
    EXPECT_NEAR(around.dot(curvature * around), 0.1, 2e-3);
    EXPECT_NEAR(curvature(1, 1), 0.0, 1e-9);
  }
}

TEST(Body, TellsInsideFromOutside) {
  const Body body(tube());
  EXPECT_NEAR(body.depth({0.0, 50.0, 9.0}), 1.0, 0.01);
  EXPECT_NEAR(body.depth({0.0, 50.0, 11.0}), -1.0, 0.01);
  EXPECT_NEAR(body.depth({0.0, 103.0, 0.0}), -3.0, 1e-9);
  EXPECT_LT(body.depth({8.0, 103.0, 8.0}), 0.0);  // beyond the rim
}

TEST(Body, RefusesWhatHasNoSurface) {
  EXPECT_THROW(Body(TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}, {}}), Error);
}

}  // namespace
}  // namespace hada
