#include "mechanics/mesh_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Geometry>

namespace hada {
namespace {

using Eigen::Vector3d;

constexpr int most_in_leaf = 4;
constexpr double on_side = 1e-9;  // weights: no ray slips through between two triangles
constexpr int deepest = 128;      // of the stack: halving never comes near it

double square_to_box(const Vector3d& p, const Vector3d& low, const Vector3d& high) {
  return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
}

// Weights of the place of a triangle that is nearest to p.
Vector3d nearest_weights(const Vector3d& p, const Vector3d& a, const Vector3d& b,
                         const Vector3d& c) {
  const Vector3d ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp),
               d6 = ac.dot(cp);
  if (d1 <= 0.0 && d2 <= 0.0) return {1, 0, 0};
  if (d3 >= 0.0 && d4 <= d3) return {0, 1, 0};
  if (d6 >= 0.0 && d5 <= d6) return {0, 0, 1};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double v = d1 / (d1 - d3);
    return {1.0 - v, v, 0.0};
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double w = d2 / (d2 - d6);
    return {1.0 - w, 0.0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0.0, 1.0 - w, w};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

}  // namespace

MeshTree::MeshTree(const TriangleMesh& mesh) : mesh_(mesh), order_(mesh.triangles.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  for (const auto& t : mesh.triangles) {
    Vector3d middle = Vector3d::Zero();
    for (const int v : t) middle += mesh.vertices_mm[std::size_t(v)] / 3.0;
    middles_.push_back(middle);
  }
  if (!order_.empty()) build(0, int(order_.size()));
}

void MeshTree::build(int first, int count) {
  const std::size_t at = nodes_.size();
  nodes_.push_back({Vector3d::Constant(HUGE_VAL), Vector3d::Constant(-HUGE_VAL), first, count});
  Vector3d low = nodes_[at].low, high = nodes_[at].high, from = low, to = high;
  for (int i = first; i < first + count; ++i) {
    const auto t = std::size_t(order_[std::size_t(i)]);
    for (const int v : mesh_.triangles[t]) {
      low = low.cwiseMin(mesh_.vertices_mm[std::size_t(v)]);
      high = high.cwiseMax(mesh_.vertices_mm[std::size_t(v)]);
    }
    from = from.cwiseMin(middles_[t]), to = to.cwiseMax(middles_[t]);
  }
  nodes_[at].low = low, nodes_[at].high = high;
  if (count <= most_in_leaf) return;
  int axis = 0;
  (to - from).maxCoeff(&axis);
  const auto begin = order_.begin() + first, middle = begin + count / 2;
  std::nth_element(begin, middle, begin + count, [&](int a, int b) {
    const double u = middles_[std::size_t(a)][axis], v = middles_[std::size_t(b)][axis];
    return u != v ? u < v : a < b;
  });
  nodes_[at].count = 0;
  build(first, count / 2);
  nodes_[at].first = int(nodes_.size());
  build(first + count / 2, count - count / 2);
}

void MeshTree::try_closest(const Vector3d& point, int triangle, MeshPlace& best) const {
  const auto& t = mesh_.triangles[std::size_t(triangle)];
  const Vector3d &a = mesh_.vertices_mm[std::size_t(t[0])],
                 &b = mesh_.vertices_mm[std::size_t(t[1])],
                 &c = mesh_.vertices_mm[std::size_t(t[2])];
  const Vector3d w = nearest_weights(point, a, b, c);
  const Vector3d place = w[0] * a + w[1] * b + w[2] * c;
  const double square = (place - point).squaredNorm();
  // Of equally near triangles the first one, in whatever order they are tried.
  if (square < best.distance || (square == best.distance && triangle < best.triangle)) {
    best = {triangle, w, place, square};
  }
}

MeshPlace MeshTree::closest(const Vector3d& point, int guess) const {
  MeshPlace best;
  best.distance = HUGE_VAL;  // squared until the end
  if (guess >= 0) try_closest(point, guess, best);
  struct Waiting {
    int node;
    double square;
  };
  std::array<Waiting, deepest> stack;
  int height = 0;
  stack[std::size_t(height++)] = {0, 0.0};
  while (height > 0) {
    const Waiting next = stack[std::size_t(--height)];
    if (next.square > best.distance) continue;
    const Node& node = nodes_[std::size_t(next.node)];
    for (int i = node.first; i < node.first + node.count; ++i) {
      try_closest(point, order_[std::size_t(i)], best);
    }
    if (node.count > 0) continue;
    Waiting near{next.node + 1, 0.0}, far{node.first, 0.0};
    for (Waiting* child : {&near, &far}) {
      const Node& box = nodes_[std::size_t(child->node)];
      child->square = square_to_box(point, box.low, box.high);
    }
    if (far.square < near.square) std::swap(near, far);
    stack[std::size_t(height++)] = far;
    stack[std::size_t(height++)] = near;
  }
  best.distance = std::sqrt(best.distance);
  return best;
}

MeshPlace MeshTree::first_hit(const Vector3d& origin, const Vector3d& direction) const {
  MeshPlace best;
  best.distance = HUGE_VAL;
  const Vector3d inverse = direction.cwiseInverse();
  const auto entry = [&](const Node& box) {
    double enter = 0.0, leave = best.distance;
    for (int axis = 0; axis < 3; ++axis) {
      if (direction[axis] == 0.0) {
        if (origin[axis] < box.low[axis] || origin[axis] > box.high[axis]) return HUGE_VAL;
        continue;
      }
      const double u = (box.low[axis] - origin[axis]) * inverse[axis],
                   v = (box.high[axis] - origin[axis]) * inverse[axis];
      enter = std::max(enter, std::min(u, v)), leave = std::min(leave, std::max(u, v));
    }
    return enter <= leave * (1.0 + 1e-12) ? enter : HUGE_VAL;
  };
  std::array<int, deepest> stack;
  int height = 0;
  stack[std::size_t(height++)] = 0;
  while (height > 0) {
    const int at = stack[std::size_t(--height)];
    const Node& node = nodes_[std::size_t(at)];
    if (entry(node) == HUGE_VAL) continue;
    for (int i = node.first; i < node.first + node.count; ++i) {
      const int triangle = order_[std::size_t(i)];
      const auto& t = mesh_.triangles[std::size_t(triangle)];
      const Vector3d& a = mesh_.vertices_mm[std::size_t(t[0])];
      const Vector3d ab = mesh_.vertices_mm[std::size_t(t[1])] - a,
                     ac = mesh_.vertices_mm[std::size_t(t[2])] - a;
      const Vector3d across = direction.cross(ac);
      const double volume = ab.dot(across);
      if (volume == 0.0) continue;
      const Vector3d from = origin - a, turned = from.cross(ab);
      const double v = from.dot(across) / volume, w = direction.dot(turned) / volume;
      if (v < -on_side || w < -on_side || v + w > 1.0 + on_side) continue;
      const double distance = ac.dot(turned) / volume;
      if (distance < 0.0 || distance >= best.distance) continue;
      best = {triangle, {1.0 - v - w, v, w}, origin + distance * direction, distance};
    }
    if (node.count > 0) continue;
    int near = at + 1, far = node.first;
    if (entry(nodes_[std::size_t(far)]) < entry(nodes_[std::size_t(near)])) std::swap(near, far);
    stack[std::size_t(height++)] = far;
    stack[std::size_t(height++)] = near;
  }
  return best;
}

}  // namespace hada
