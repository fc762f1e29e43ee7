#include "synth/leg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hada {
namespace {

using Eigen::Vector3d;
using Places = std::vector<Vector3d>;
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

// A place of the foot's outline in front, or on the instep, and one behind it, or on the sole; half
// its width; in shares of the foot's length. The origin is the middle of the ankle.
struct FootSection {
  Vector3d front, back;
  double half_width;
  double oval = 0.0;  // as the leg's own outline is
};

// Around the ankle, as seen from a pivot before the instep: a quarter of a turn.
FootSection ankle_section(double share, double ankle_radius) {
  const double turn = 0.5 * std::numbers::pi * share, instep = 0.13;
  const Vector3d pivot(0.0, 0.0, ankle_radius + instep);
  const Vector3d back(0.0, -std::sin(turn), -std::cos(turn));
  const Knots far{{{0.0, instep + 2.0 * ankle_radius}, {0.3, 0.51}, {0.55, 0.54}, {1.0, 0.38}}};
  const Knots width{{{0.0, ankle_radius}, {0.35, 0.138}, {0.65, 0.145}, {1.0, 0.165}}};
  return {pivot + instep * back, pivot + through(far, share) * back, through(width, share),
          0.03 * (1.0 - share) * (1.0 - share)};
}

// From the instep to where the toes begin to close.
FootSection middle_section(double share, double ankle_radius) {
  const FootSection first = ankle_section(1.0, ankle_radius);
  const double sole = first.back.y();
  const Knots top{{{0.0, first.front.y()}, {0.35, -0.185}, {0.7, -0.245}, {1.0, -0.265}}};
  const Knots bottom{{{0.0, sole}, {0.4, sole + 0.01}, {0.7, sole - 0.01}, {1.0, sole - 0.01}}};
  const Knots width{{{0.0, first.half_width}, {0.4, 0.185}, {0.75, 0.205}, {1.0, 0.185}}};
  const double z = first.front.z() + share * 0.4;
  return {{0.0, through(top, share), z}, {0.0, through(bottom, share), z}, through(width, share)};
}

// Rings of the outline from just before the tip of the toes up to the ankle, then the tip.
Places foot_rings(const LegShape& shape, int& rings) {
  const double ankle = shape.ankle_mm / (2.0 * std::numbers::pi * shape.foot_mm);
  std::vector<FootSection> sections;
  const int toe = shape.rings / 10, middle = shape.rings / 5, heel = shape.rings / 4;
  const FootSection last = middle_section(1.0, ankle);
  const Vector3d middle_of_toes = 0.5 * (last.front + last.back), ahead(0.0, 0.0, 0.15);
  for (int k = toe; k > 0; --k) {
    const double rise = 0.5 * std::numbers::pi * k / (toe + 1.0);
    const Vector3d shift = std::sin(rise) * ahead, middle_here = middle_of_toes + shift;
    sections.push_back({middle_here + std::cos(rise) * (last.front - middle_of_toes),
                        middle_here + std::cos(rise) * (last.back - middle_of_toes),
                        std::cos(rise) * last.half_width});
  }
  for (int k = middle; k > 0; --k) sections.push_back(middle_section(double(k) / middle, ankle));
  for (int k = heel; k > 0; --k) sections.push_back(ankle_section(double(k) / heel, ankle));
  Places places;
  for (const FootSection& s : sections) {
    const Vector3d middle_here = 0.5 * (s.front + s.back), out = s.front - middle_here;
    for (int segment = 0; segment < shape.segments; ++segment) {
      const double turn = 2.0 * std::numbers::pi * segment / shape.segments;
      const double r = 1.0 + s.oval * std::cos(2.0 * turn);
      places.push_back(shape.foot_mm * (middle_here + r * std::cos(turn) * out +
                                        r * std::sin(turn) * Vector3d(s.half_width, 0.0, 0.0)));
    }
  }
  places.push_back(shape.foot_mm * (middle_of_toes + ahead));
  rings = int(sections.size());
  return places;
}

}  // namespace

TriangleMesh leg_mesh(const LegShape& shape) {
  const Knots girth{
      {{0.0, shape.ankle_mm}, {0.33, shape.calf_mm}, {0.55, shape.knee_mm}, {1.0, shape.thigh_mm}}};
  const Knots bend{{{0.0, 0.0}, {0.33, -shape.bend_mm}, {0.55, 0.3 * shape.bend_mm}, {1.0, 0.0}}};
  TriangleMesh mesh;
  const int segments = shape.segments;
  int below = 0;  // rings of the foot
  Vector3d tip(0.0, 0.0, 0.0);
  if (shape.foot_mm > 0.0) {
    mesh.vertices_mm = foot_rings(shape, below);
    tip = mesh.vertices_mm.back();
    mesh.vertices_mm.pop_back();
  }
  const int rings = below + shape.rings;
  for (int ring = 0; ring <= shape.rings; ++ring) {
    const double t = double(ring) / shape.rings;
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
  mesh.vertices_mm.push_back(tip);
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
