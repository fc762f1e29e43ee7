#include "sheet/flat_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "sheet/arrangement.h"

namespace hada {
namespace {

using Eigen::Vector2d;

struct Ray {
  double angle;
  double length;
  Crease crease;
};

// The folds that leave a vertex, in order of their direction.
std::vector<std::vector<Ray>> folds_around(const Sheet& sheet) {
  std::vector<std::vector<Ray>> around(sheet.flat.size());
  for (int h = 0; h < int(sheet.halves.size()); ++h) {
    const Crease crease = sheet.creases[std::size_t(h / 2)];
    if (!is_folded(crease)) continue;
    const Vector2d way =
        sheet.flat[std::size_t(sheet.target(h))] - sheet.flat[std::size_t(sheet.origin(h))];
    around[std::size_t(sheet.origin(h))].push_back(
        {std::atan2(way.y(), way.x()), way.norm(), crease});
  }
  for (auto& rays : around) {
    std::sort(rays.begin(), rays.end(),
              [](const Ray& a, const Ray& b) { return a.angle < b.angle; });
  }
  return around;
}

std::string place(const Sheet& sheet, int vertex) {
  char text[96];
  const Vector2d& p = sheet.flat[std::size_t(vertex)];
  std::snprintf(text, sizeof text, "vertex %d at (%.6g, %.6g): ", vertex, p.x(), p.y());
  return text;
}

}  // namespace

std::vector<FlatFlaw> flat_flaws(const Sheet& sheet, double tolerance) {
  std::vector<bool> on_border(sheet.flat.size(), false);
  for (int h = 0; h < int(sheet.halves.size()); ++h) {
    if (sheet.is_border(h / 2)) on_border[std::size_t(sheet.origin(h))] = true;
  }
  const auto around = folds_around(sheet);
  const double allowed = tolerance * size_of(sheet.flat);
  std::vector<FlatFlaw> flaws;
  for (int v = 0; v < sheet.vertices(); ++v) {
    const auto& rays = around[std::size_t(v)];
    if (on_border[std::size_t(v)] || rays.empty()) continue;
    char text[160];
    if (rays.size() % 2 != 0) {
      std::snprintf(text, sizeof text,
                    "%zu folds meet, an odd number (Kawasaki's theorem asks for an even one)",
                    rays.size());
      flaws.push_back({v, place(sheet, v) + text});
      continue;
    }
    double alternating = 0.0, shortest = std::numeric_limits<double>::infinity();
    int balance = 0;
    bool assigned = true;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const double next = rays[(i + 1) % rays.size()].angle;
      const double angle =
          next - rays[i].angle + (i + 1 == rays.size() ? 2.0 * std::numbers::pi : 0.0);
      alternating += i % 2 == 0 ? angle : -angle;
      shortest = std::min(shortest, rays[i].length);
      balance += rays[i].crease == Crease::mountain ? 1 : -1;
      assigned = assigned && rays[i].crease != Crease::unassigned;
    }
    if (std::abs(alternating) * shortest > allowed) {
      std::snprintf(
          text, sizeof text,
          "alternate angles sum to %.4f and %.4f degrees, not to 180 (Kawasaki's theorem)",
          180.0 + 90.0 * alternating / std::numbers::pi,
          180.0 - 90.0 * alternating / std::numbers::pi);
      flaws.push_back({v, place(sheet, v) + text});
    } else if (assigned && std::abs(balance) != 2) {
      std::snprintf(
          text, sizeof text,
          "%d mountains and %d valleys meet, which do not differ by 2 (Maekawa's theorem)",
          (int(rays.size()) + balance) / 2, (int(rays.size()) - balance) / 2);
      flaws.push_back({v, place(sheet, v) + text});
    }
  }
  return flaws;
}

}  // namespace hada
