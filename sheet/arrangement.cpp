#include "sheet/arrangement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <unordered_map>

namespace hada {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Points of which no two are closer than the snap distance, found by their square of a lattice.
class Points {
 public:
  explicit Points(double snap) : snap_(snap) {}

  int at(const Vector2d& place) {
    const auto [col, row] = square(place);
    for (std::int64_t i = col - 1; i <= col + 1; ++i) {
      for (std::int64_t j = row - 1; j <= row + 1; ++j) {
        const auto [begin, end] = squares_.equal_range(key(i, j));
        for (auto it = begin; it != end; ++it) {
          if ((places_[std::size_t(it->second)] - place).norm() <= snap_) return it->second;
        }
      }
    }
    places_.push_back(place);
    squares_.emplace(key(col, row), int(places_.size()) - 1);
    return int(places_.size()) - 1;
  }
  std::vector<Vector2d>& places() { return places_; }

 private:
  std::pair<std::int64_t, std::int64_t> square(const Vector2d& p) const {
    return {std::int64_t(std::floor(p.x() / snap_)), std::int64_t(std::floor(p.y() / snap_))};
  }
  static std::uint64_t key(std::int64_t i, std::int64_t j) {
    return std::uint64_t(i) * 0x9e3779b97f4a7c15u ^ std::uint64_t(j) * 0xc2b2ae3d27d4eb4fu;
  }
  double snap_;
  std::vector<Vector2d> places_;
  std::unordered_multimap<std::uint64_t, int> squares_;
};

// Where a point lies along a line, and how far off it.
struct Foot {
  double along;
  double off;
};

Foot foot(const Vector2d& p, const Vector2d& from, const Vector2d& to) {
  const Vector2d way = to - from;
  const double length = way.norm();
  return {(p - from).dot(way) / length, std::abs(cross(p - from, way)) / length};
}

struct Line {
  int from, to;               // points
  std::vector<int> on;        // points on it, in any order
  std::vector<int> segments;  // in order
};

void add_crossings(std::vector<Line>& lines, Points& points, double snap) {
  std::vector<int> order(lines.size());
  std::iota(order.begin(), order.end(), 0);
  const auto low = [&](const Line& line) {
    return std::min(points.places()[std::size_t(line.from)].x(),
                    points.places()[std::size_t(line.to)].x());
  };
  const auto high = [&](const Line& line) {
    return std::max(points.places()[std::size_t(line.from)].x(),
                    points.places()[std::size_t(line.to)].x());
  };
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return low(lines[std::size_t(a)]) < low(lines[std::size_t(b)]); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    Line& a = lines[std::size_t(order[i])];
    const double end = high(a) + snap;
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      Line& b = lines[std::size_t(order[j])];
      if (low(b) > end) break;
      const Vector2d p = points.places()[std::size_t(a.from)];
      const Vector2d q = points.places()[std::size_t(b.from)];
      const Vector2d r = points.places()[std::size_t(a.to)] - p;
      const Vector2d s = points.places()[std::size_t(b.to)] - q;
      const double sine = cross(r, s);
      // Nearly parallel lines meet at ends only, and those are found as points on lines.
      if (std::abs(sine) < snap * std::max(r.norm(), s.norm())) continue;
      const double t = cross(q - p, s) / sine, u = cross(q - p, r) / sine;
      const double near_t = snap / r.norm(), near_u = snap / s.norm();
      if (t < near_t || t > 1.0 - near_t || u < near_u || u > 1.0 - near_u) continue;
      const int point = points.at(p + t * r);
      a.on.push_back(point);
      b.on.push_back(point);
    }
  }
}

void add_touching(std::vector<Line>& lines, const std::vector<Vector2d>& places, double snap) {
  std::vector<int> by_x(places.size());
  std::iota(by_x.begin(), by_x.end(), 0);
  const auto x = [&](int i) { return places[std::size_t(i)].x(); };
  std::sort(by_x.begin(), by_x.end(), [&](int a, int b) { return x(a) < x(b); });
  for (Line& line : lines) {
    const Vector2d from = places[std::size_t(line.from)], to = places[std::size_t(line.to)];
    const double length = (to - from).norm();
    const double low = std::min(from.x(), to.x()) - snap, high = std::max(from.x(), to.x()) + snap;
    auto it = std::lower_bound(by_x.begin(), by_x.end(), low,
                               [&](int i, double value) { return x(i) < value; });
    for (; it != by_x.end() && x(*it) <= high; ++it) {
      const Foot place = foot(places[std::size_t(*it)], from, to);
      if (place.off <= snap && place.along > 0.0 && place.along < length) line.on.push_back(*it);
    }
  }
}

// Cells to the left of the half-segments 2 s (from start to end) and 2 s + 1.
void trace_cells(Arrangement& result) {
  const auto& places = result.points;
  const int halves = 2 * int(result.segments.size());
  const auto origin = [&](int h) {
    return result.segments[std::size_t(h / 2)][std::size_t(h % 2)];
  };
  std::vector<std::vector<int>> leaving(places.size());
  for (int h = 0; h < halves; ++h) leaving[std::size_t(origin(h))].push_back(h);
  std::vector<int> place_in(std::size_t(halves), 0);
  for (auto& around : leaving) {
    const auto angle = [&](int h) {
      const Vector2d way = places[std::size_t(origin(h ^ 1))] - places[std::size_t(origin(h))];
      return std::atan2(way.y(), way.x());
    };
    std::sort(around.begin(), around.end(), [&](int a, int b) { return angle(a) < angle(b); });
    for (std::size_t k = 0; k < around.size(); ++k) place_in[std::size_t(around[k])] = int(k);
  }
  result.cells_of.assign(result.segments.size(), {-1, -1});
  std::vector<bool> seen(std::size_t(halves), false);
  for (int first = 0; first < halves; ++first) {
    if (seen[std::size_t(first)]) continue;
    std::vector<int> walk;
    double area = 0.0;
    for (int h = first; !seen[std::size_t(h)];) {
      seen[std::size_t(h)] = true;
      walk.push_back(h);
      area += cross(places[std::size_t(origin(h))], places[std::size_t(origin(h ^ 1))]);
      const auto& around = leaving[std::size_t(origin(h ^ 1))];
      const std::size_t back = std::size_t(place_in[std::size_t(h ^ 1)]);
      h = around[(back + around.size() - 1) % around.size()];
    }
    if (area <= 0.0) continue;
    std::vector<int> corners;
    for (const int h : walk) {
      corners.push_back(origin(h));
      result.cells_of[std::size_t(h / 2)][std::size_t(h % 2)] = int(result.cells.size());
    }
    result.cells.push_back(std::move(corners));
  }
}

}  // namespace

Arrangement arrangement(const std::vector<Vector2d>& vertices,
                        const std::vector<std::array<int, 2>>& lines, double snap) {
  Arrangement result;
  Points points(snap);
  for (const Vector2d& vertex : vertices) result.point_of.push_back(points.at(vertex));
  // Lines that lie on each other from end to end are one.
  std::map<std::array<int, 2>, int> line_at;
  std::vector<Line> unique;
  for (const auto& [from, to] : lines) {
    const int a = result.point_of[std::size_t(from)], b = result.point_of[std::size_t(to)];
    const std::array<int, 2> ends{std::min(a, b), std::max(a, b)};
    if (a == b || line_at.contains(ends)) continue;
    line_at[ends] = int(unique.size());
    unique.push_back({ends[0], ends[1], {}, {}});
  }
  add_crossings(unique, points, snap);
  add_touching(unique, points.places(), snap);
  result.points = std::move(points.places());
  std::map<std::array<int, 2>, int> segment_at;
  for (Line& line : unique) {
    const Vector2d from = result.points[std::size_t(line.from)];
    const Vector2d to = result.points[std::size_t(line.to)];
    std::vector<std::pair<double, int>> stops;
    for (const int p : line.on)
      stops.emplace_back(foot(result.points[std::size_t(p)], from, to).along, p);
    std::sort(stops.begin(), stops.end());
    stops.emplace_back(0.0, line.to);
    int last = line.from;
    for (const auto& [along, point] : stops) {
      if (point == last) continue;
      const std::array<int, 2> ends{std::min(last, point), std::max(last, point)};
      const auto [found, is_new] = segment_at.emplace(ends, int(result.segments.size()));
      if (is_new) result.segments.push_back(ends);
      line.segments.push_back(found->second);
      last = point;
    }
  }
  for (const auto& [from, to] : lines) {
    const int a = result.point_of[std::size_t(from)], b = result.point_of[std::size_t(to)];
    const auto found = line_at.find({std::min(a, b), std::max(a, b)});
    std::vector<int> along;
    if (found != line_at.end()) along = unique[std::size_t(found->second)].segments;
    if (a > b) std::reverse(along.begin(), along.end());
    result.segments_of.push_back(std::move(along));
  }
  trace_cells(result);
  return result;
}

double size_of(const std::vector<Vector2d>& points) {
  Vector2d low = points.front(), high = low;
  for (const Vector2d& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).maxCoeff();
}

double snap_distance(const std::vector<Vector2d>& vertices,
                     const std::vector<std::array<int, 2>>& lines, double noise) {
  const double size = std::max(size_of(vertices), 1e-300);
  const double most = 0.01 * size, least = std::clamp(noise, 1e-13 * size, 0.1 * most);
  std::vector<double> distances{least, most};
  const auto add = [&](double distance) {
    if (distance > least && distance < most) distances.push_back(distance);
  };
  std::vector<Vector2d> sorted = vertices;
  std::sort(sorted.begin(), sorted.end(),
            [](const Vector2d& a, const Vector2d& b) { return a.x() < b.x(); });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (std::size_t j = i + 1; j < sorted.size() && sorted[j].x() < sorted[i].x() + most; ++j) {
      add((sorted[j] - sorted[i]).norm());
    }
  }
  for (const auto& [a, b] : lines) {
    const Vector2d from = vertices[std::size_t(a)], to = vertices[std::size_t(b)];
    const double length = (to - from).norm();
    if (!(length > most)) continue;
    const double left = std::min(from.x(), to.x()) - most,
                 right = std::max(from.x(), to.x()) + most;
    auto p = std::lower_bound(sorted.begin(), sorted.end(), left,
                              [](const Vector2d& q, double value) { return q.x() < value; });
    for (; p != sorted.end() && p->x() <= right; ++p) {
      const Foot place = foot(*p, from, to);
      if (place.along > most && place.along < length - most) add(place.off);
    }
  }
  std::sort(distances.begin(), distances.end());
  double best = 0.0, snap = std::sqrt(least * most);
  for (std::size_t i = 0; i + 1 < distances.size(); ++i) {
    const double ratio = distances[i + 1] / distances[i];
    if (ratio <= best) continue;
    best = ratio;
    snap = std::sqrt(distances[i] * distances[i + 1]);
  }
  return snap;
}

}  // namespace hada
