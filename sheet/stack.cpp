#include "sheet/stack.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "sheet/arrangement.h"

namespace hada {
namespace {

using Eigen::Vector3d;

// Gives the faces of a pile the same up, beginning with its first face.
void turn_up(const std::vector<std::vector<int>>& beside, const std::vector<Plate>& plates,
             int first, Stack& stack) {
  const Vector3d& normal = plates[std::size_t(first)].normal;
  const Vector3d up = normal.z() < -1e-9 ? Vector3d(-normal) : normal;
  std::vector<int> open{first};
  stack.up[std::size_t(first)] = up;
  while (!open.empty()) {
    const int face = open.back();
    open.pop_back();
    for (const int other : beside[std::size_t(face)]) {
      Vector3d& its = stack.up[std::size_t(other)];
      if (its.squaredNorm() > 0.0) continue;
      const Vector3d& n = plates[std::size_t(other)].normal;
      its = n.dot(up) < 0.0 ? Vector3d(-n) : n;
      open.push_back(other);
    }
  }
}

// Places in the pile from the bottom up: the longest way down. Flaps that are tucked into each
// other in a ring leave none at the bottom; there the one that lies on the fewest begins.
std::vector<int> levels_of(const std::vector<std::vector<int>>& above, std::vector<int> below) {
  std::vector<int> level(above.size(), 0);
  std::vector<bool> placed(above.size(), false);
  for (std::size_t count = 0; count < above.size(); ++count) {
    std::size_t lowest = above.size();
    for (std::size_t f = 0; f < above.size(); ++f) {
      if (!placed[f] && (lowest == above.size() || below[f] < below[lowest])) lowest = f;
    }
    placed[lowest] = true;
    for (const int f : above[lowest]) {
      const std::size_t k = std::size_t(f);
      --below[k];
      if (!placed[k]) level[k] = std::max(level[k], level[lowest] + 1);
    }
  }
  return level;
}

}  // namespace

Stack stack_of(const std::vector<Plate>& plates, const std::vector<FaceOrder>& order, double size) {
  const double near = 1e-6 * size;
  const std::size_t faces = plates.size();
  std::vector<std::vector<int>> beside(faces);
  std::vector<const FaceOrder*> together;
  for (const FaceOrder& o : order) {
    if (o.order == 0 || std::size_t(std::max(o.face, o.other)) >= faces) continue;
    const Plate &a = plates[std::size_t(o.face)], &b = plates[std::size_t(o.other)];
    if (std::abs(a.normal.dot(b.normal)) < 1.0 - 1e-6) continue;
    if (std::abs(a.normal.dot(b.centre - a.centre)) > near) continue;
    together.push_back(&o);
    beside[std::size_t(o.face)].push_back(o.other);
    beside[std::size_t(o.other)].push_back(o.face);
  }
  Stack stack{{}, std::vector<Vector3d>(faces, Vector3d::Zero())};
  for (std::size_t f = 0; f < faces; ++f) {
    if (stack.up[f].squaredNorm() == 0.0) turn_up(beside, plates, int(f), stack);
  }
  std::vector<std::vector<int>> above(faces);
  std::vector<int> below(faces, 0);
  for (const FaceOrder* o : together) {
    const std::size_t other = std::size_t(o->other);
    const bool print_up = plates[other].normal.dot(stack.up[other]) > 0.0;
    const bool first = (o->order > 0) == print_up;
    above[first ? other : std::size_t(o->face)].push_back(first ? o->face : o->other);
    ++below[first ? std::size_t(o->face) : other];
  }
  stack.level = levels_of(above, std::move(below));
  return stack;
}

Stack stack_of(const Sheet& sheet, const std::vector<FaceOrder>& order) {
  return stack_of(plates_of(sheet), order, size_of(sheet.flat));
}

std::optional<Hit> seen(const Sheet& sheet, const Stack& stack, const Ray& ray) {
  const double close = 1e-6 * size_of(sheet.flat);
  std::optional<Hit> best;
  double best_level = 0.0;
  const auto found = hits(sheet, ray);
  if (found.empty()) return best;
  const double nearest = (found.front().place - ray.eye).norm();
  for (const Hit& other : found) {
    if ((other.place - ray.eye).norm() > nearest + close) break;
    const std::size_t face = std::size_t(other.face);
    const double level = stack.level[face] * (stack.up[face].dot(ray.way) < 0.0 ? 1.0 : -1.0);
    if (best && level <= best_level) continue;
    best = other;
    best_level = level;
  }
  return best;
}

}  // namespace hada
