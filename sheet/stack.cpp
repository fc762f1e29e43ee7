#include "sheet/stack.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "sheet/arrangement.h"

namespace hada {
namespace {

using Eigen::Vector3d;

// Face `face` lies on `other`, both in one plane.
struct Lies {
  int face, other;
};

struct Plane {
  Vector3d normal;
  double offset;
};

Plane plane_of(const Sheet& sheet, int face) {
  const auto corners = sheet.corners_of(face);
  const auto at = [&](int v) -> const Vector3d& { return sheet.folded[std::size_t(v)]; };
  Vector3d sum = Vector3d::Zero(), centre = Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += (at(corners[i]) - at(corners[0])).cross(at(corners[i + 1]) - at(corners[0]));
  }
  for (const int v : corners) centre += at(v) / double(corners.size());
  const Vector3d normal = sum.normalized();
  return {normal, normal.dot(centre)};
}

// Gives the faces of a pile the same up, beginning with its first face.
void turn_up(const std::vector<std::vector<int>>& beside, const std::vector<Plane>& planes,
             int first, Stack& stack) {
  const Vector3d& normal = planes[std::size_t(first)].normal;
  const Vector3d up = normal.z() < -1e-9 ? Vector3d(-normal) : normal;
  std::vector<int> open{first};
  stack.up[std::size_t(first)] = up;
  while (!open.empty()) {
    const int face = open.back();
    open.pop_back();
    for (const int other : beside[std::size_t(face)]) {
      Vector3d& its = stack.up[std::size_t(other)];
      if (its.squaredNorm() > 0.0) continue;
      const Vector3d& n = planes[std::size_t(other)].normal;
      its = n.dot(up) < 0.0 ? Vector3d(-n) : n;
      open.push_back(other);
    }
  }
}

}  // namespace

Stack stack_of(const Sheet& sheet, const std::vector<FaceOrder>& order) {
  const double near = 1e-6 * size_of(sheet.flat);
  const std::size_t faces = std::size_t(sheet.faces());
  std::vector<Plane> planes;
  for (int f = 0; f < sheet.faces(); ++f) planes.push_back(plane_of(sheet, f));
  std::vector<std::vector<int>> beside(faces);
  std::vector<const FaceOrder*> together;
  for (const FaceOrder& o : order) {
    if (o.order == 0 || std::max(o.face, o.other) >= sheet.faces()) continue;
    const Plane &a = planes[std::size_t(o.face)], &b = planes[std::size_t(o.other)];
    const double turn = a.normal.dot(b.normal);
    if (std::abs(turn) < 1.0 - 1e-6) continue;
    if (std::abs(a.offset - (turn > 0.0 ? b.offset : -b.offset)) > near) continue;
    together.push_back(&o);
    beside[std::size_t(o.face)].push_back(o.other);
    beside[std::size_t(o.other)].push_back(o.face);
  }
  Stack stack{std::vector<int>(faces, 0), std::vector<Vector3d>(faces, Vector3d::Zero())};
  for (int f = 0; f < sheet.faces(); ++f) {
    if (stack.up[std::size_t(f)].squaredNorm() == 0.0) turn_up(beside, planes, f, stack);
  }
  std::vector<Lies> above;
  for (const FaceOrder* o : together) {
    const std::size_t other = std::size_t(o->other);
    const bool print_up = planes[other].normal.dot(stack.up[other]) > 0.0;
    const bool first = (o->order > 0) == print_up;
    above.push_back(first ? Lies{o->face, o->other} : Lies{o->other, o->face});
  }
  // The longest way down; flaps that are tucked into each other in a ring end it too.
  for (int round = 0; round < sheet.faces(); ++round) {
    bool moved = false;
    for (const Lies& pair : above) {
      int& level = stack.level[std::size_t(pair.face)];
      const int least = stack.level[std::size_t(pair.other)] + 1;
      if (level >= least || least > sheet.faces()) continue;
      level = least;
      moved = true;
    }
    if (!moved) break;
  }
  return stack;
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
