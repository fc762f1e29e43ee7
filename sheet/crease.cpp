#include "sheet/crease.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

int before(const Sheet& sheet, int half) {
  int h = half;
  while (sheet.half(h).next != half) h = sheet.half(h).next;
  return h;
}

int leaving(const Sheet& sheet, int face, int vertex) {
  for (const int h : sheet.halves_of(face)) {
    if (sheet.origin(h) == vertex) return h;
  }
  return -1;
}

double angle_of(Crease crease) {
  if (crease == Crease::valley) return std::numbers::pi;
  return crease == Crease::mountain ? -std::numbers::pi : 0.0;
}

}  // namespace

int split_edge(Sheet& sheet, int edge, double share) {
  const int there = 2 * edge, back = there + 1;  // from a to b, from b to a
  const int after = before(sheet, back);
  const std::size_t a = std::size_t(sheet.origin(there)), b = std::size_t(sheet.target(there));
  const int vertex = sheet.vertices();
  sheet.flat.push_back((1.0 - share) * sheet.flat[a] + share * sheet.flat[b]);
  sheet.folded.push_back((1.0 - share) * sheet.folded[a] + share * sheet.folded[b]);
  sheet.creases.push_back(sheet.creases[std::size_t(edge)]);
  sheet.fold_angles.push_back(sheet.fold_angles[std::size_t(edge)]);
  const int on = int(sheet.halves.size()), from_b = on + 1;  // from the vertex to b, from b to it
  sheet.halves.push_back({vertex, sheet.half(there).face, sheet.half(there).next});
  sheet.halves.push_back({int(b), sheet.half(back).face, back});
  sheet.halves[std::size_t(there)].next = on;
  sheet.halves[std::size_t(back)].origin = vertex;
  sheet.halves[std::size_t(after)].next = from_b;
  // Where the border turns back at b it came from the edge itself.
  if (after == there) sheet.halves[std::size_t(on)].next = from_b;
  return vertex;
}

int split_face(Sheet& sheet, int face, int from, int to, Crease crease) {
  const int at_from = leaving(sheet, face, from), at_to = leaving(sheet, face, to);
  const int into_from = before(sheet, at_from), into_to = before(sheet, at_to);
  const int there = int(sheet.halves.size()), back = there + 1;
  const int fresh = sheet.faces();
  sheet.halves.push_back({from, fresh, at_to});
  sheet.halves.push_back({to, face, at_from});
  sheet.halves[std::size_t(into_to)].next = back;
  sheet.halves[std::size_t(into_from)].next = there;
  sheet.face_halves[std::size_t(face)] = back;
  sheet.face_halves.push_back(there);
  for (const int h : sheet.halves_of(fresh)) sheet.halves[std::size_t(h)].face = fresh;
  sheet.creases.push_back(crease);
  sheet.fold_angles.push_back(angle_of(crease));
  return there / 2;
}

CreaseCut straight_cut(const Vector2d& from, const Vector2d& to, double tolerance) {
  const Vector2d way = (to - from).normalized(), left(-way.y(), way.x());
  const double length = (to - from).norm();
  CreaseCut cut;
  cut.side = [=](const Vector3d& p) { return left.dot(p.head<2>() - from); };
  cut.within = [=](const Vector3d& p) {
    const double along = way.dot(p.head<2>() - from);
    return along > -tolerance && along < length + tolerance;
  };
  cut.tolerance = tolerance;
  return cut;
}

std::vector<int> insert_crease(Sheet& sheet, std::vector<Vector3d> where, const CreaseCut& cut,
                               Crease crease, const std::vector<bool>& chosen) {
  const auto may = [&](int face) {
    return face >= 0 &&
           (chosen.empty() || (face < int(chosen.size()) && chosen[std::size_t(face)]));
  };
  const int edges = sheet.edges(), faces = sheet.faces();
  std::vector<bool> on(where.size(), false);
  for (std::size_t v = 0; v < where.size(); ++v) {
    on[v] = std::abs(cut.side(where[v])) <= cut.tolerance && cut.within(where[v]);
  }
  for (int e = 0; e < edges; ++e) {
    if (!may(sheet.half(2 * e).face) && !may(sheet.half(2 * e + 1).face)) continue;
    const std::size_t a = std::size_t(sheet.origin(2 * e)), b = std::size_t(sheet.target(2 * e));
    const double da = cut.side(where[a]), db = cut.side(where[b]);
    if (std::min(da, db) >= -cut.tolerance || std::max(da, db) <= cut.tolerance) continue;
    const double share = da / (da - db);
    const Vector3d place = (1.0 - share) * where[a] + share * where[b];
    if (!cut.within(place)) continue;
    split_edge(sheet, e, share);
    where.push_back(place);
    on.push_back(true);
  }
  std::vector<int> along;
  for (int f = 0; f < faces; ++f) {
    if (!may(f)) continue;
    std::vector<int> crossed;
    for (const int v : sheet.corners_of(f)) {
      if (on[std::size_t(v)]) crossed.push_back(v);
    }
    if (crossed.size() != 2) continue;
    int old = -1;
    for (const int h : sheet.halves_of(f)) {
      const bool lies_on = on[std::size_t(sheet.origin(h))] && on[std::size_t(sheet.target(h))];
      if (lies_on) old = h / 2;
    }
    if (old < 0) along.push_back(split_face(sheet, f, crossed[0], crossed[1], crease));
    if (old >= 0 && !sheet.is_border(old)) along.push_back(old);
  }
  std::sort(along.begin(), along.end());
  along.erase(std::unique(along.begin(), along.end()), along.end());
  return along;
}

}  // namespace hada
