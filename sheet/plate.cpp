#include "sheet/plate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace hada {
namespace {

using Eigen::Vector3d;
using Places = std::vector<Vector3d>;

struct Span {
  double from, to;
};

// What a plate cuts out of the line in which it and another's plane meet, if it reaches to both
// sides of that plane.
std::optional<Span> cut_of(const Plate& plate, const Plate& other, const Vector3d& along,
                           double tolerance) {
  Span span{1e300, -1e300};
  double low = 0.0, high = 0.0;
  const std::size_t corners = plate.corners.size();
  for (std::size_t i = 0; i < corners; ++i) {
    const Vector3d &a = plate.corners[i], &b = plate.corners[(i + 1) % corners];
    const double da = other.normal.dot(a - other.corners[0]);
    const double db = other.normal.dot(b - other.corners[0]);
    low = std::min(low, da);
    high = std::max(high, da);
    if ((da < 0.0) == (db < 0.0)) continue;
    const double at = along.dot(a + (b - a) * (da / (da - db)));
    span.from = std::min(span.from, at);
    span.to = std::max(span.to, at);
  }
  if (low > -tolerance || high < tolerance) return {};
  return span;
}

bool are_apart(const Plate& one, const Plate& other, double by) {
  return (one.low.array() > other.high.array() + by).any() ||
         (other.low.array() > one.high.array() + by).any();
}

Vector3d area_vector(const Places& polygon) {
  Vector3d twice = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    twice += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
  }
  return 0.5 * twice;
}

// What is left of a polygon on the inner side of a line (Sutherland, Hodgman 1974), into `inside`.
void clip(const Places& polygon, const Vector3d& from, const Vector3d& inner, Places& inside) {
  inside.clear();
  const std::size_t count = polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d &a = polygon[i], &b = polygon[i + 1 == count ? 0 : i + 1];
    const double da = inner.dot(a - from), db = inner.dot(b - from);
    if (da >= 0.0) inside.push_back(a);
    if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) {
      inside.push_back(a + (b - a) * (da / (da - db)));
    }
  }
}

}  // namespace

Plate plate_of(const std::vector<int>& corners, const Places& places) {
  Plate plate;
  plate.centre = Vector3d::Zero();
  plate.low = plate.high = places[std::size_t(corners[0])];
  for (const int v : corners) {
    const Vector3d& p = places[std::size_t(v)];
    plate.corners.push_back(p);
    plate.centre += p / double(corners.size());
    plate.low = plate.low.cwiseMin(p);
    plate.high = plate.high.cwiseMax(p);
  }
  plate.normal = area_vector(plate.corners).normalized();
  return plate;
}

std::vector<Plate> plates_of(const Sheet& sheet) {
  return plates_of(sheet, sheet.folded);
}

std::vector<Plate> plates_of(const Sheet& sheet, const Places& places) {
  std::vector<Plate> plates;
  for (int f = 0; f < sheet.faces(); ++f) plates.push_back(plate_of(sheet.corners_of(f), places));
  return plates;
}

bool pierce(const Plate& one, const Plate& other, double tolerance) {
  if (are_apart(one, other, 0.0)) return false;
  const Vector3d along = one.normal.cross(other.normal).normalized();
  const auto first = cut_of(one, other, along, tolerance);
  if (!first) return false;
  const auto second = cut_of(other, one, along, tolerance);
  if (!second) return false;
  return std::min(first->to, second->to) - std::max(first->from, second->from) > tolerance;
}

std::optional<Vector3d> common_place(const Plate& one, const Plate& other, double near) {
  if (are_apart(one, other, near)) return {};
  for (const Vector3d& p : one.corners) {
    if (std::abs(other.normal.dot(p - other.corners[0])) > near) return {};
  }
  Places common = one.corners, inside;  // of all pairs of a sheet: a hand waits for it
  inside.reserve(one.corners.size() + other.corners.size());
  for (std::size_t i = 0; i < other.corners.size() && common.size() > 2; ++i) {
    const Vector3d &a = other.corners[i], &b = other.corners[(i + 1) % other.corners.size()];
    clip(common, a, other.normal.cross(b - a).normalized(), inside);
    std::swap(common, inside);
  }
  // Slivers along a side that both touch are rounding.
  const double size = (other.high - other.low).norm();
  if (common.size() < 3 || area_vector(common).norm() < near * size) return {};
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& p : common) middle += p / double(common.size());
  return middle;
}

Eigen::Vector2d mark_on(const Plate& plate, const Vector3d& place) {
  Eigen::Matrix<double, 3, 2> sides;
  sides << plate.corners[1] - plate.corners[0], plate.corners.back() - plate.corners[0];
  return (sides.transpose() * sides).inverse() * (sides.transpose() * (place - plate.corners[0]));
}

Vector3d marked_place(const Plate& plate, const Eigen::Vector2d& mark) {
  return plate.corners[0] + mark.x() * (plate.corners[1] - plate.corners[0]) +
         mark.y() * (plate.corners.back() - plate.corners[0]);
}

}  // namespace hada
