#include "synth/leg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hada {
namespace {

using Knots = std::array<std::array<double, 2>, 4>;  // place and value

// A curve through four knots, flat at both ends, whose curvature has no steps (cubic spline): a
// stocking's pressure follows the curvature and would show them.
double through(const Knots& knots, double at) {
  const auto width = [&](std::size_t i) { return knots[i + 1][0] - knots[i][0]; };
  const auto steepness = [&](std::size_t i) { return (knots[i + 1][1] - knots[i][1]) / width(i); };
  // Both inner slopes m from m1 / h1 + 2 m2 (1 / h1 + 1 / h2) + m3 / h2 = 3 (d1 / h1 + d2 / h2).
  const auto weight = [&](std::size_t i) { return 2.0 * (1.0 / width(i) + 1.0 / width(i + 1)); };
  const auto side = [&](std::size_t i) {
    return 3.0 * (steepness(i) / width(i) + steepness(i + 1) / width(i + 1));
  };
  const double across = 1.0 / width(1), whole = weight(0) * weight(1) - across * across;
  const std::array<double, 4> slope{0.0, (side(0) * weight(1) - across * side(1)) / whole,
                                    (side(1) * weight(0) - across * side(0)) / whole, 0.0};
  const std::size_t i = at < knots[1][0] ? 0 : at < knots[2][0] ? 1 : 2;
  const double t = (at - knots[i][0]) / width(i), t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * knots[i][1] + (t3 - 2 * t2 + t) * width(i) * slope[i] +
         (3 * t2 - 2 * t3) * knots[i + 1][1] + (t3 - t2) * width(i) * slope[i + 1];
}

}  // namespace

TriangleMesh leg_mesh(const LegShape& shape) {
  const Knots girth{
      {{0.0, shape.ankle_mm}, {0.33, shape.calf_mm}, {0.55, shape.knee_mm}, {1.0, shape.thigh_mm}}};
  const Knots bend{{{0.0, 0.0}, {0.33, -shape.bend_mm}, {0.55, 0.3 * shape.bend_mm}, {1.0, 0.0}}};
  TriangleMesh mesh;
  const int rings = shape.rings, segments = shape.segments;
  for (int ring = 0; ring <= rings; ++ring) {
    const double t = double(ring) / rings;
    const double radius = through(girth, t) / (2.0 * std::numbers::pi);
    const double calf = std::exp(-std::pow((t - 0.33) / 0.15, 2.0));
    for (int segment = 0; segment < segments; ++segment) {
      const double turn = 2.0 * std::numbers::pi * segment / segments;
      // The calf bulges backward and the shin is narrow.
      const double r = radius * (1.0 - 0.07 * calf * std::cos(turn) + 0.03 * std::cos(2.0 * turn));
      mesh.vertices_mm.emplace_back(r * std::sin(turn), t * shape.length_mm,
                                    through(bend, t) + r * std::cos(turn));
    }
  }
  const auto vertex = [&](int ring, int segment) { return ring * segments + segment % segments; };
  const int bottom = int(mesh.vertices_mm.size()), top = bottom + 1;
  mesh.vertices_mm.emplace_back(0.0, 0.0, 0.0);
  mesh.vertices_mm.emplace_back(0.0, shape.length_mm, 0.0);
  for (int s = 0; s < segments; ++s) {
    for (int ring = 0; ring < rings; ++ring) {
      const int a = vertex(ring, s), b = vertex(ring, s + 1), c = vertex(ring + 1, s + 1),
                d = vertex(ring + 1, s);
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
    mesh.triangles.push_back({bottom, vertex(0, s + 1), vertex(0, s)});
    mesh.triangles.push_back({top, vertex(rings, s), vertex(rings, s + 1)});
  }
  return mesh;
}

}  // namespace hada
