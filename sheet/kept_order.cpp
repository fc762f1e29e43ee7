#include "sheet/kept_order.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>

#include "sheet/arrangement.h"
#include "sheet/places.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Places = std::vector<Vector3d>;

constexpr double one_plane = 1e-6;  // of the sheet

Vector3d normal_of(const Sheet& sheet, const Places& places, int face) {
  const auto corners = sheet.corners_of(face);
  const auto at = [&](std::size_t i) -> const Vector3d& { return places[std::size_t(corners[i])]; };
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += (at(i) - at(0)).cross(at(i + 1) - at(0));
  }
  return sum.normalized();
}

// What is left of a polygon on the inner side of a line (Sutherland, Hodgman 1974).
Places clipped(const Places& polygon, const Vector3d& from, const Vector3d& inner) {
  Places inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = inner.dot(a - from), db = inner.dot(b - from);
    if (da >= 0.0) inside.push_back(a);
    if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) {
      inside.push_back(a + (b - a) * (da / (da - db)));
    }
  }
  return inside;
}

double area_of(const Places& polygon, const Vector3d& normal) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
  }
  return 0.5 * std::abs(sum.dot(normal));
}

}  // namespace

std::optional<Vector3d> common_place(const Sheet& sheet, int face, int other) {
  const double size = size_of(sheet.flat), near = one_plane * size;
  const Vector3d normal = normal_of(sheet, sheet.folded, other);
  const auto corners = sheet.corners_of(other);
  const Vector3d& first = sheet.folded[std::size_t(corners[0])];
  Places common;
  for (const int v : sheet.corners_of(face)) {
    common.push_back(sheet.folded[std::size_t(v)]);
    if (std::abs(normal.dot(common.back() - first)) > near) return {};
  }
  for (std::size_t i = 0; i < corners.size() && common.size() > 2; ++i) {
    const Vector3d& a = sheet.folded[std::size_t(corners[i])];
    const Vector3d& b = sheet.folded[std::size_t(corners[(i + 1) % corners.size()])];
    common = clipped(common, a, normal.cross(b - a).normalized());
  }
  // Slivers along a side that both touch are rounding.
  if (common.size() < 3 || area_of(common, normal) < near * size) return {};
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& p : common) middle += p / double(common.size());
  return middle;
}

std::vector<FaceOrder> split_orders(const Sheet& sheet, const std::vector<FaceOrder>& order,
                                    int faces_before, const std::vector<int>& creases) {
  std::map<int, std::vector<int>> parts;
  for (const int e : creases) {
    // A face that is cut keeps its number on one side of the crease.
    const int fresh = sheet.half(2 * e).face, old = sheet.half(2 * e + 1).face;
    if (fresh >= faces_before) parts[old] = {old, fresh};
  }
  const auto parts_of = [&](int face) {
    const auto found = parts.find(face);
    return found == parts.end() ? std::vector<int>{face} : found->second;
  };
  std::vector<FaceOrder> result;
  for (const FaceOrder& o : order) {
    for (const int face : parts_of(o.face)) {
      for (const int other : parts_of(o.other)) {
        if (common_place(sheet, face, other)) result.push_back({face, other, o.order});
      }
    }
  }
  return result;
}

std::vector<FaceOrder> moved_orders(const Sheet& sheet, const std::vector<FaceOrder>& order,
                                    const Places& shortly_before) {
  const double near = one_plane * size_of(sheet.flat);
  std::map<std::pair<int, int>, int> known;
  for (const FaceOrder& o : order) known[{o.face, o.other}] = o.order;
  Sheet before = sheet;
  before.folded = shortly_before;
  std::vector<FaceOrder> result;
  for (int a = 0; a < sheet.faces(); ++a) {
    for (int b = a + 1; b < sheet.faces(); ++b) {
      const auto place = common_place(sheet, a, b);
      if (!place) continue;
      const Vector3d way = folded_place(before, a, flat_place(sheet, a, *place)) -
                           folded_place(before, b, flat_place(sheet, b, *place));
      const auto found = known.find({a, b}), turned = known.find({b, a});
      if (way.norm() < near && found != known.end()) {
        result.push_back({a, b, found->second});
      } else if (way.norm() < near && turned != known.end()) {
        result.push_back({b, a, turned->second});
      } else {
        const double above = normal_of(sheet, shortly_before, b).dot(way);
        result.push_back({a, b, above > 0.0 ? 1 : -1});
      }
    }
  }
  return result;
}

void shut_as_ordered(Sheet& sheet, const std::vector<FaceOrder>& order) {
  std::map<std::pair<int, int>, int> known;
  for (const FaceOrder& o : order) known[{o.face, o.other}] = o.order;
  for (int e = 0; e < sheet.edges(); ++e) {
    double& angle = sheet.fold_angles[std::size_t(e)];
    if (std::abs(angle) < std::numbers::pi - 1e-6) continue;
    const int a = sheet.half(2 * e).face, b = sheet.half(2 * e + 1).face;
    auto found = known.find({a, b});
    if (found == known.end()) found = known.find({b, a});
    if (found == known.end()) continue;
    // A valley lays print on print.
    angle = found->second > 0 ? std::numbers::pi : -std::numbers::pi;
    sheet.creases[std::size_t(e)] = found->second > 0 ? Crease::valley : Crease::mountain;
  }
}

}  // namespace hada
