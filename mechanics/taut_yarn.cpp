#include "mechanics/taut_yarn.h"

#include <algorithm>
#include <array>
#include <optional>

#include <Eigen/Geometry>

#include "core/parallel.h"

namespace hada {
namespace {

using Eigen::Vector3d;

constexpr int most_triangles = 1000;  // under one spring
constexpr int halvings = 24;

// Where the plane (through `a`, normal `m`) crosses edges of triangles on the way from `a` to `b`;
// nothing if it comes out elsewhere.
std::optional<Places> crossed_edges(const Body& body, const Vector3d& a, int from,
                                    const Vector3d& b, int to, const Vector3d& m) {
  Places crossed;
  const auto& mesh = body.mesh();
  const Vector3d way = b - a;
  int triangle = from, entered = -1;  // by which side of it
  for (int step = 0; step < most_triangles; ++step) {
    if (triangle == to) return crossed;
    const auto& t = mesh.triangles[std::size_t(triangle)];
    std::array<double, 3> over{};
    for (std::size_t s = 0; s < 3; ++s) over[s] = (mesh.vertices_mm[std::size_t(t[s])] - a).dot(m);
    int leave = -1;
    double best = -HUGE_VAL;
    Vector3d place = a;
    for (int s = 0; s < 3; ++s) {
      const auto i = std::size_t(s), j = std::size_t((s + 1) % 3);
      if (s == entered || (over[i] < 0.0) == (over[j] < 0.0)) continue;
      const Vector3d &p = mesh.vertices_mm[std::size_t(t[i])],
                     &q = mesh.vertices_mm[std::size_t(t[j])];
      const Vector3d cut = p + (q - p) * (over[i] / (over[i] - over[j]));
      const double progress = (cut - a).dot(way);
      if (progress > best) best = progress, leave = s, place = cut;
    }
    if (leave < 0 || best > 1.0001 * way.squaredNorm()) return std::nullopt;
    const int next = body.neighbours()[std::size_t(triangle)][std::size_t(leave)];
    if (next < 0) return std::nullopt;
    crossed.push_back(place);
    const auto& back = body.neighbours()[std::size_t(next)];
    entered = int(std::find(back.begin(), back.end(), triangle) - back.begin());
    triangle = next;
  }
  return std::nullopt;
}

// An end of a piece of yarn, and the triangle that it lies on; -1 above the body.
struct End {
  Vector3d place;
  int triangle;
};

// Where the way along the body is lost, halves are laid on the surface until each piece lies in one
// triangle or above the body.
void lay_halves(const Body& body, const End& a, const End& b, int guess, int left,
                Places& between) {
  if (left <= 0 || (a.triangle >= 0 && a.triangle == b.triangle)) return;
  const Vector3d middle = 0.5 * (a.place + b.place);
  const MeshPlace at = body.tree().closest(middle, guess);
  const bool inside = (at.place - middle).dot(body.facet_normal(at.triangle)) > 0.0;
  const End half = inside ? End{at.place, at.triangle} : End{middle, -1};
  // Above the body there is little to find.
  const int next = inside ? left - 1 : left - 4;
  Places first, second;
  lay_halves(body, a, half, at.triangle, next, first);
  lay_halves(body, half, b, at.triangle, next, second);
  between.insert(between.end(), first.begin(), first.end());
  if (inside || !first.empty() || !second.empty()) between.push_back(half.place);
  between.insert(between.end(), second.begin(), second.end());
}

// The points of `path` that a string from a to b, pulled taut, lies on.
Places upper_hull(const Vector3d& a, const Vector3d& b, const Vector3d& up, const Places& path) {
  const Vector3d along = (b - a).normalized(), height = (up - along * along.dot(up)).normalized();
  const auto flat = [&](const Vector3d& p) {
    return Eigen::Vector2d((p - a).dot(along), (p - a).dot(height));
  };
  Places hull{a};
  const auto add = [&](const Vector3d& p) {
    while (hull.size() > 1) {
      const Eigen::Vector2d u = flat(hull.back()) - flat(hull[hull.size() - 2]),
                            v = flat(p) - flat(hull.back());
      if (u.x() * v.y() - u.y() * v.x() < 0.0) break;  // turns down: the last one carries
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Vector3d& p : path) add(p);
  add(b);
  return {hull.begin() + 1, hull.end() - 1};
}

TautYarns::Line taut(const Body& body, const WornKnit& knit, TautYarns::Line line) {
  const auto i = std::size_t(line.from), j = std::size_t(line.to);
  const Vector3d &a = knit.places[i], &b = knit.places[j];
  const Vector3d up = (knit.normals[i] + knit.normals[j]).normalized();
  const Vector3d across = (b - a).cross(up);
  auto path = crossed_edges(body, a, knit.triangles[i], b, knit.triangles[j], across);
  if (!path) {
    // The other way round starts in another triangle, which may know the way.
    path = crossed_edges(body, b, knit.triangles[j], a, knit.triangles[i], across);
    if (path) std::reverse(path->begin(), path->end());
  }
  if (path) {
    line.between = upper_hull(a, b, up, *path);
  } else {
    lay_halves(body, {a, knit.triangles[i]}, {b, knit.triangles[j]}, knit.triangles[i], halvings,
               line.between);
  }
  return line;
}

}  // namespace

std::vector<TautYarns::Line> straight_lines(const WornKnit& knit) {
  std::vector<TautYarns::Line> lines;
  for (const auto& spring : springs_of(knit)) lines.push_back({spring.from, spring.to, {}});
  return lines;
}

TautYarns taut_yarns(const Body& body, const WornKnit& knit) {
  TautYarns yarns{straight_lines(knit)};
  for_each_index(int(yarns.lines.size()), [&](int i) {
    auto& line = yarns.lines[std::size_t(i)];
    line = taut(body, knit, line);
  });
  for (const auto& line : yarns.lines) {
    yarns.inserted += int(line.between.size());
    yarns.cut += !line.between.empty();
  }
  return yarns;
}

int penetrating(const Body& body, const WornKnit& knit, const std::vector<TautYarns::Line>& lines,
                double allowed_mm) {
  constexpr int samples = 4;  // of each straight piece, inside it
  std::vector<char> deep(lines.size(), 0);
  for_each_index(int(lines.size()), [&](int i) {
    const auto& line = lines[std::size_t(i)];
    Places way{knit.places[std::size_t(line.from)]};
    way.insert(way.end(), line.between.begin(), line.between.end());
    way.push_back(knit.places[std::size_t(line.to)]);
    int guess = knit.triangles[std::size_t(line.from)];
    for (std::size_t k = 0; k + 1 < way.size() && !deep[std::size_t(i)]; ++k) {
      for (int s = 1; s <= samples; ++s) {
        const Vector3d p = way[k] + (way[k + 1] - way[k]) * (s / (samples + 1.0));
        if (body.depth(p, guess) > allowed_mm) deep[std::size_t(i)] = 1;
      }
    }
  });
  return int(std::count(deep.begin(), deep.end(), 1));
}

}  // namespace hada
