#include "app/worn_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "synth/knit_loops.h"

namespace hada {
namespace {

using Eigen::Vector3d;

constexpr int sides = 4;

// Adds a ring of corners around a place of a yarn; the yarn runs across `normal` and `across`.
void add_corners(TriangleMesh& mesh, const Vector3d& place, const Vector3d& normal,
                 const Vector3d& across, double radius) {
  for (int s = 0; s < sides; ++s) {
    const double turn = 2.0 * std::numbers::pi * s / sides;
    mesh.vertices_mm.push_back(place +
                               radius * (std::cos(turn) * normal + std::sin(turn) * across));
  }
}

void join_corners(TriangleMesh& mesh, int ring, int next) {
  for (int s = 0; s < sides; ++s) {
    const int a = ring + s, b = ring + (s + 1) % sides, c = next + s, d = next + (s + 1) % sides;
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({b, d, c});
  }
}

// A place of the knit and its normal, at fractions of wales and courses.
struct OnKnit {
  Vector3d place, normal;
};

OnKnit on_knit(const WornKnit& knit, double wale, double course) {
  const int wales = knit.net.wales;
  const int row = std::clamp(int(std::floor(course)), 0, knit.net.courses - 2);
  const int col = (int(std::floor(wale)) % wales + wales) % wales, next = (col + 1) % wales;
  const double u = wale - std::floor(wale), v = course - row;
  const auto mixed = [&](const Places& values) -> Vector3d {
    const auto at = [&](int r, int c) { return values[std::size_t(r * wales + c)]; };
    return (1.0 - v) * ((1.0 - u) * at(row, col) + u * at(row, next)) +
           v * ((1.0 - u) * at(row + 1, col) + u * at(row + 1, next));
  };
  return {mixed(knit.places), mixed(knit.normals).normalized()};
}

Knit<> loop_shape(double radius_mm) {
  Knit<> shape;  // spacings do not matter: the curve is in wales and courses
  shape.wale_mm = shape.course_mm = 1.0;
  shape.yarn_radius_mm = 1.0;  // as coarse as the curve is made
  shape.loop_depth_mm = 3.0 * radius_mm;
  return shape;
}

}  // namespace

TriangleMesh yarn_mesh(const WornKnit& knit, const TautYarns& yarns, double radius_mm) {
  TriangleMesh mesh;
  for (const auto& line : yarns.lines) {
    Places way{knit.places[std::size_t(line.from)]};
    way.insert(way.end(), line.between.begin(), line.between.end());
    way.push_back(knit.places[std::size_t(line.to)]);
    const Vector3d& normal = knit.normals[std::size_t(line.from)];
    const Vector3d across = (way.back() - way.front()).cross(normal).normalized();
    const int first = int(mesh.vertices_mm.size());
    for (const Vector3d& place : way) {
      add_corners(mesh, place + radius_mm * normal, normal, across, radius_mm);
    }
    for (int ring = 0; ring + 1 < int(way.size()); ++ring) {
      join_corners(mesh, first + ring * sides, first + (ring + 1) * sides);
    }
  }
  return mesh;
}

Places loop_ring(const WornKnit& knit, int course, double radius_mm) {
  const Knit<> shape = loop_shape(radius_mm);
  const auto curve = loop_curve(shape);
  Places ring;
  for (int wale = 0; wale < knit.net.wales; ++wale) {
    for (const auto& [x, y, z] : curve) {
      const OnKnit at = on_knit(knit, wale + x, course + y);
      ring.push_back(at.place + (z + shape.loop_depth_mm + radius_mm) * at.normal);
    }
  }
  return ring;
}

TriangleMesh loop_mesh(const WornKnit& knit, double radius_mm) {
  TriangleMesh mesh;
  for (int course = 0; course < knit.net.courses; ++course) {
    const Places ring = loop_ring(knit, course, radius_mm);
    const int first = int(mesh.vertices_mm.size()), count = int(ring.size());
    const auto at = [&](int i) { return ring[std::size_t((i + count) % count)]; };
    for (int i = 0; i < count; ++i) {
      const Vector3d along = (at(i + 1) - at(i - 1)).normalized();
      const Vector3d outward =
          knit.normals[std::size_t(course * knit.net.wales + i / (count / knit.net.wales))];
      const Vector3d across = along.cross(outward).normalized();
      add_corners(mesh, at(i), across.cross(along), across, radius_mm);
    }
    for (int i = 0; i < count; ++i) {
      join_corners(mesh, first + i * sides, first + (i + 1) % count * sides);
    }
  }
  return mesh;
}

}  // namespace hada
