#include "sheet/kept_order.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "sheet/arrangement.h"
#include "sheet/plate.h"

namespace hada {
namespace {

using Eigen::Vector3d;
using Places = std::vector<Vector3d>;

constexpr double one_plane = 1e-6;      // of the sheet
constexpr double kept_together = 1e-3;  // of the sheet: what follows in steps gives that much

}  // namespace

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
  const auto plates = plates_of(sheet);
  const double near = one_plane * size_of(sheet.flat);
  std::vector<FaceOrder> result;
  for (const FaceOrder& o : order) {
    for (const int face : parts_of(o.face)) {
      for (const int other : parts_of(o.other)) {
        const Plate &one = plates[std::size_t(face)], &two = plates[std::size_t(other)];
        if (common_place(one, two, near)) result.push_back({face, other, o.order});
      }
    }
  }
  return result;
}

std::vector<FaceOrder> moved_orders(const Sheet& sheet, const std::vector<FaceOrder>& order,
                                    const Places& shortly_before) {
  const double size = size_of(sheet.flat);
  std::map<std::pair<int, int>, int> known;
  for (const FaceOrder& o : order) known[{o.face, o.other}] = o.order;
  const auto plates = plates_of(sheet), before = plates_of(sheet, shortly_before);
  std::vector<FaceOrder> result;
  for (int a = 0; a < sheet.faces(); ++a) {
    for (int b = a + 1; b < sheet.faces(); ++b) {
      const Plate &one = plates[std::size_t(a)], &two = plates[std::size_t(b)];
      const auto place = common_place(one, two, one_plane * size);
      if (!place) continue;
      const Vector3d way = marked_place(before[std::size_t(a)], mark_on(one, *place)) -
                           marked_place(before[std::size_t(b)], mark_on(two, *place));
      const bool together = way.norm() < kept_together * size;
      const auto found = known.find({a, b}), turned = known.find({b, a});
      if (together && found != known.end()) {
        result.push_back({a, b, found->second});
      } else if (together && turned != known.end()) {
        result.push_back({b, a, turned->second});
      } else {
        result.push_back({a, b, before[std::size_t(b)].normal.dot(way) > 0.0 ? 1 : -1});
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
