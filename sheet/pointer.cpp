#include "sheet/pointer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace hada {
namespace {

using Eigen::Vector3d;

const Vector3d& at(const Sheet& sheet, int vertex) {
  return sheet.folded[std::size_t(vertex)];
}

Vector3d normal_of(const Sheet& sheet, int face) {
  const auto corners = sheet.corners_of(face);
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vector3d& a = at(sheet, corners[0]);
    sum += (at(sheet, corners[i]) - a).cross(at(sheet, corners[i + 1]) - a);
  }
  return sum.normalized();
}

Vector3d centre_of(const Sheet& sheet, int face) {
  const auto corners = sheet.corners_of(face);
  Vector3d sum = Vector3d::Zero();
  for (const int v : corners) sum += at(sheet, v);
  return sum / double(corners.size());
}

double distance(const Ray& ray, const Vector3d& place) {
  return ray.way.normalized().cross(place - ray.eye).norm();
}

// The ways that divide an angle into parts, counted from one of its sides.
std::vector<Vector3d> parted(const Vector3d& side, double angle, const Vector3d& normal,
                             int parts) {
  std::vector<Vector3d> ways;
  for (int k = 1; k < parts; ++k) {
    ways.push_back(Eigen::AngleAxisd(angle * k / parts, normal) * side);
  }
  return ways;
}

}  // namespace

std::vector<Hit> hits(const Sheet& sheet, const Ray& ray) {
  std::vector<std::pair<double, Hit>> found;
  for (int f = 0; f < sheet.faces(); ++f) {
    const Vector3d normal = normal_of(sheet, f);
    const auto corners = sheet.corners_of(f);
    const double towards = normal.dot(ray.way);
    if (std::abs(towards) < 1e-12 * ray.way.norm()) continue;
    const double far = normal.dot(at(sheet, corners[0]) - ray.eye) / towards;
    if (far <= 0.0) continue;
    const Vector3d place = ray.eye + far * ray.way;
    bool inside = true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector3d& a = at(sheet, corners[i]);
      const Vector3d& b = at(sheet, corners[(i + 1) % corners.size()]);
      inside = inside && normal.dot((b - a).cross(place - a)) >= 0.0;
    }
    if (inside) found.push_back({far, Hit{f, place}});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Hit> places;
  for (const auto& [far, hit] : found) places.push_back(hit);
  return places;
}

std::optional<Hit> hit(const Sheet& sheet, const Ray& ray) {
  const auto found = hits(sheet, ray);
  return found.empty() ? std::nullopt : std::optional<Hit>(found.front());
}

CreaseCut drawn_cut(const Ray& from, const Ray& to, double tolerance) {
  // Both rays and the eyes between them: a plane, and in it what lies between the rays.
  const Vector3d a = from.way.normalized(), b = to.way.normalized();
  const Vector3d gap = to.eye - from.eye;
  const Vector3d across = a.cross(b).norm() > 1e-9 ? a.cross(b) : a.cross(gap);
  const Vector3d normal = across.normalized();
  CreaseCut cut;
  cut.side = [=, eye = from.eye](const Vector3d& p) { return normal.dot(p - eye); };
  cut.within = [=, first = from.eye, second = to.eye](const Vector3d& p) {
    const double past_first = normal.dot(a.cross(p - first));
    const double before_second = normal.dot((p - second).cross(b));
    return past_first > -tolerance && before_second > -tolerance && (p - first).dot(a) > 0.0;
  };
  cut.tolerance = tolerance;
  return cut;
}

std::optional<Snap> snapped(const Sheet& sheet, int face, const Ray& ray, double reach, int parts) {
  std::optional<Snap> best;
  double nearest = reach;
  const auto halves = sheet.halves_of(face);
  for (const int h : halves) {
    const double off = distance(ray, at(sheet, sheet.origin(h)));
    if (off > nearest) continue;
    nearest = off;
    best = Snap{at(sheet, sheet.origin(h)), sheet.origin(h), -1};
  }
  if (best) return best;
  for (const int h : halves) {
    for (int k = 1; k < parts; ++k) {
      const double share = double(k) / parts;
      const Vector3d place =
          (1.0 - share) * at(sheet, sheet.origin(h)) + share * at(sheet, sheet.target(h));
      const double off = distance(ray, place);
      if (off > nearest) continue;
      nearest = off;
      best = Snap{place, -1, h / 2};
    }
  }
  return best;
}

std::vector<Vector3d> corner_directions(const Sheet& sheet, int face, int corner, int parts) {
  for (const int h : sheet.halves_of(face)) {
    const int next = sheet.half(h).next;
    if (sheet.origin(next) != corner) continue;
    const Vector3d leaving = (at(sheet, sheet.target(next)) - at(sheet, corner)).normalized();
    const Vector3d arriving = (at(sheet, sheet.origin(h)) - at(sheet, corner)).normalized();
    const double angle = std::atan2(leaving.cross(arriving).norm(), leaving.dot(arriving));
    return parted(leaving, angle, normal_of(sheet, face), parts);
  }
  return {};
}

std::vector<Vector3d> edge_directions(const Sheet& sheet, int face, int half, int parts) {
  const Vector3d along =
      (at(sheet, sheet.target(half)) - at(sheet, sheet.origin(half))).normalized();
  return parted(along, std::numbers::pi, normal_of(sheet, face), parts);
}

int axis_of_click(const Sheet& sheet, int face, const Vector3d& click) {
  const Vector3d centre = centre_of(sheet, face);
  const Vector3d across = normal_of(sheet, face).cross(centre - click);  // normal of the plane G
  int axis = -1;
  double furthest = -1.0;
  for (const int h : sheet.halves_of(face)) {
    if (sheet.is_border(h / 2)) continue;
    const Vector3d &a = at(sheet, sheet.origin(h)), &b = at(sheet, sheet.target(h));
    const double da = across.dot(a - click), db = across.dot(b - click);
    if (da * db > 0.0 || da == db) continue;
    const double far = (a + (b - a) * (da / (da - db)) - click).norm();
    if (far <= furthest) continue;
    furthest = far;
    axis = h / 2;
  }
  return axis;
}

std::optional<double> angle_of_drag(const Vector3d& on_axis, const Vector3d& along,
                                    const Vector3d& click, const Ray& pointer) {
  const Vector3d axis = along.normalized();
  const double towards = axis.dot(pointer.way);
  if (std::abs(towards) < 1e-9 * pointer.way.norm()) return std::nullopt;
  const Vector3d place = pointer.eye + pointer.way * (axis.dot(click - pointer.eye) / towards);
  const Vector3d middle = on_axis + axis * axis.dot(click - on_axis);
  const Vector3d from = click - middle, to = place - middle;
  return std::atan2(axis.dot(from.cross(to)), from.dot(to));
}

bool should_turn_view(const Vector3d& along, const Ray& pointer, double least_sine) {
  return std::abs(along.normalized().dot(pointer.way.normalized())) < least_sine;
}

}  // namespace hada
