#include "sheet/aim.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Geometry>

#include "sheet/arrangement.h"

namespace hada {
namespace {

using Eigen::Vector3d;

const Vector3d& at(const Sheet& sheet, int vertex) {
  return sheet.folded[std::size_t(vertex)];
}

std::vector<Stretch> edges_of(const Sheet& sheet, int face) {
  std::vector<Stretch> edges;
  for (const int h : sheet.halves_of(face)) {
    edges.push_back({at(sheet, sheet.origin(h)), at(sheet, sheet.target(h))});
  }
  return edges;
}

std::optional<Vector3d> crossing(const Stretch& a, const Stretch& b) {
  const Vector3d u = a[1] - a[0], v = b[1] - b[0], w = b[0] - a[0];
  const Vector3d across = u.cross(v);
  const double size = u.norm() * v.norm(), slack = 1e-9;
  if (across.norm() < 1e-6 * size) return std::nullopt;
  const double s = w.cross(v).dot(across) / across.squaredNorm();
  const double t = w.cross(u).dot(across) / across.squaredNorm();
  if (std::min(s, t) < -slack || std::max(s, t) > 1.0 + slack) return std::nullopt;
  if (std::abs(w.dot(across)) > slack * across.norm()) return std::nullopt;
  return a[0] + s * u;
}

double distance(const Ray& ray, const Vector3d& place) {
  return ray.way.normalized().cross(place - ray.eye).norm();
}

// The place on an endless line that is nearest to a line of sight.
std::optional<Vector3d> nearest_on(const Vector3d& from, const Vector3d& way, const Ray& ray) {
  const Vector3d look = ray.way.normalized(), along = way.normalized();
  const Vector3d across = along.cross(look);
  if (across.norm() < 1e-6) return std::nullopt;
  return from + along * ((ray.eye - from).cross(look).dot(across) / across.squaredNorm());
}

void keep_near(std::vector<Stretch>& stretches, const Vector3d& place, double close) {
  std::erase_if(stretches, [&](const Stretch& line) {
    return (line[1] - line[0]).normalized().cross(place - line[0]).norm() > close;
  });
}

// Of some faces the one that a pointer beside or above them may still mean: one with a snap within
// reach; of those that share it the one whose middle is nearest.
int face_near(const Sheet& sheet, const std::vector<int>& faces, const Ray& ray,
              const AimOptions& options) {
  int best = -1;
  double nearest = options.reach, nearest_middle = 0.0;
  for (const int f : faces) {
    const auto snap = snapped(sheet, f, ray, options.reach, options.edge_parts);
    if (!snap) continue;
    const double off = distance(ray, snap->place), slack = 1e-6 * options.reach;
    Vector3d middle = Vector3d::Zero();
    const auto corners = sheet.corners_of(f);
    for (const int v : corners) middle += at(sheet, v) / double(corners.size());
    const double middle_off = distance(ray, middle);
    const bool nearer = off < nearest - slack;
    const bool alike = best >= 0 && off < nearest + slack && middle_off < nearest_middle;
    if (!nearer && !alike) continue;
    nearest = off;
    nearest_middle = middle_off;
    best = f;
  }
  return best;
}

// The face whose snaps and guides count.
int meant_face(const Sheet& sheet, const std::optional<Hit>& under, const Ray& ray,
               const AimOptions& options) {
  if (options.faces.empty()) {
    if (under) return under->face;
    std::vector<int> all(std::size_t(sheet.faces()));
    std::iota(all.begin(), all.end(), 0);
    return face_near(sheet, all, ray, options);
  }
  if (const int near = face_near(sheet, options.faces, ray, options); near >= 0) return near;
  for (const Hit& met : hits(sheet, ray)) {
    if (std::find(options.faces.begin(), options.faces.end(), met.face) != options.faces.end()) {
      return met.face;
    }
  }
  return -1;
}

std::optional<Aim> free_place(const std::optional<Hit>& under, const Ray& ray,
                              const AimOptions& options) {
  Aim aim;
  if (under) {
    aim.place = under->place;
    aim.by = Drawn::paper;
    aim.face = under->face;
    return aim;
  }
  const double ground = options.start ? options.start->z() : 0.0;
  if (std::abs(ray.way.z()) < 1e-9 * ray.way.norm()) return std::nullopt;
  const double far = (ground - ray.eye.z()) / ray.way.z();
  if (far <= 0.0) return std::nullopt;
  aim.place = ray.eye + far * ray.way;
  return aim;
}

// A direction as far as it goes on a face.
Stretch within(const std::vector<Stretch>& edges, const Vector3d& from, const Vector3d& way,
               double size) {
  Vector3d end = from;
  for (const Stretch& edge : edges) {
    const auto place = crossing({from, from + size * way}, edge);
    if (place && (*place - from).norm() > (end - from).norm()) end = *place;
  }
  return {from, end};
}

// The ways that divide the angle which a face has at a place of its border: a corner's, or inside
// an edge half a turn.
std::vector<Vector3d> ways_from(const Sheet& sheet, int face, const Vector3d& place, int parts) {
  constexpr double close = 1e-9;
  for (const int h : sheet.halves_of(face)) {
    const Vector3d &a = at(sheet, sheet.origin(h)), &b = at(sheet, sheet.target(h));
    if ((a - place).norm() < close) return corner_directions(sheet, face, sheet.origin(h), parts);
    if ((b - place).norm() < close) return corner_directions(sheet, face, sheet.target(h), parts);
    const double share = (place - a).dot(b - a) / (b - a).squaredNorm();
    const bool on = share > 0.0 && share < 1.0 && (a + share * (b - a) - place).norm() < close;
    if (on) return edge_directions(sheet, face, h, parts);
  }
  return {};
}

// The directions that divide the angles which all layers have at a place.
std::vector<Stretch> directions_from(const Sheet& sheet, const Vector3d& place, int parts) {
  const double size = 2.0 * size_of(sheet.flat);
  std::vector<Stretch> directions;
  for (int f = 0; f < sheet.faces(); ++f) {
    const auto edges = edges_of(sheet, f);
    for (const Vector3d& way : ways_from(sheet, f, place, parts)) {
      const bool known = std::any_of(directions.begin(), directions.end(), [&](const Stretch& d) {
        return ((d[1] - d[0]).normalized() - way).norm() < 1e-9;
      });
      const Stretch guide = within(edges, place, way, size);
      if (!known && guide[1] != guide[0]) directions.push_back(guide);
    }
  }
  return directions;
}

}  // namespace

std::vector<Stretch> guides_of(const Sheet& sheet, int face, int parts) {
  const auto edges = edges_of(sheet, face);
  const double size = 2.0 * size_of(sheet.flat);
  std::vector<Stretch> guides;
  for (const int corner : sheet.corners_of(face)) {
    const Vector3d& from = at(sheet, corner);
    for (const Vector3d& way : corner_directions(sheet, face, corner, parts)) {
      const Stretch guide = within(edges, from, way, size);
      if (guide[1] != guide[0]) guides.push_back(guide);
    }
  }
  return guides;
}

std::vector<Vector3d> crossings_of(const std::vector<Stretch>& stretches) {
  std::vector<Vector3d> places;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (const auto place = crossing(stretches[i], stretches[j])) places.push_back(*place);
    }
  }
  return places;
}

std::optional<Aim> aim(const Sheet& sheet, const Stack& stack, const Ray& ray,
                       const AimOptions& options) {
  const auto under = seen(sheet, stack, ray);
  const int face = meant_face(sheet, under, ray, options);
  auto result = free_place(under, ray, options);
  if (face < 0 && !options.start) return result;
  std::vector<Stretch> stretches = options.lines;
  std::optional<Snap> snap;
  if (face >= 0) {
    snap = snapped(sheet, face, ray, options.reach, options.edge_parts);
    for (const auto& list : {guides_of(sheet, face, options.corner_parts), edges_of(sheet, face)}) {
      stretches.insert(stretches.end(), list.begin(), list.end());
    }
  }
  Aim found;
  found.face = face;
  if (snap && snap->vertex >= 0) {
    found.place = snap->place;
    found.by = Drawn::vertex;
    return found;
  }
  // Ends of lines count as much as vertices do.
  double nearest = options.reach;
  for (const Stretch& line : options.lines) {
    for (const Vector3d& end : line) {
      if (distance(ray, end) >= nearest) continue;
      nearest = distance(ray, end);
      found.place = end;
      found.by = Drawn::vertex;
    }
  }
  if (found.by == Drawn::vertex) return found;
  if (snap) {
    nearest = distance(ray, snap->place);
    found.place = snap->place;
    found.by = Drawn::division;
  }
  for (const Vector3d& place : crossings_of(stretches)) {
    // Where a guide meets an edge at its division both are meant.
    if (distance(ray, place) >= nearest - 1e-9) continue;
    nearest = distance(ray, place);
    found.place = place;
    found.by = Drawn::crossing;
  }
  if (found.by == Drawn::division) {
    const auto a = at(sheet, sheet.origin(2 * snap->edge)),
               b = at(sheet, sheet.target(2 * snap->edge));
    for (int k = 1; k < options.edge_parts; ++k) {
      found.points.push_back(a + (b - a) * k / options.edge_parts);
    }
    return found;
  }
  if (found.by == Drawn::crossing) {
    keep_near(stretches, found.place, 1e-9);
    found.guides = std::move(stretches);
    return found;
  }
  if (!options.start) return result;
  const Vector3d& from = *options.start;
  auto directions = directions_from(sheet, from, options.corner_parts);
  nearest = options.reach;
  for (const Stretch& guide : directions) {
    const auto place = nearest_on(from, guide[1] - from, ray);
    if (!place || distance(ray, *place) >= nearest) continue;
    if ((*place - from).dot(guide[1] - from) <= 0.0) continue;
    nearest = distance(ray, *place);
    found.place = *place;
    found.by = Drawn::direction;
  }
  if (found.by != Drawn::direction) return result;
  found.guides = std::move(directions);
  return found;
}

}  // namespace hada
