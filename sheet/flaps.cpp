#include "sheet/flaps.h"

#include <algorithm>

#include "core/error.h"
#include "sheet/arrangement.h"

namespace hada {
namespace {

using Eigen::Vector3d;

// Whether the print of a face that lies level is turned up.
bool print_is_up(const Sheet& sheet, int face) {
  double area = 0.0;
  for (const int h : sheet.halves_of(face)) {
    const Vector3d &p = sheet.folded[std::size_t(sheet.origin(h))],
                   &q = sheet.folded[std::size_t(sheet.target(h))];
    area += p.x() * q.y() - p.y() * q.x();
  }
  return area > 0.0;
}

}  // namespace

std::vector<bool> moving_faces(const Sheet& sheet, const std::vector<int>& creases,
                               const CreaseCut& cut, const std::string& where) {
  if (creases.empty()) throw Error(where + ": its line crosses no paper from side to side");
  std::vector<bool> moving(std::size_t(sheet.faces()), false),
      barrier(std::size_t(sheet.edges()), false);
  for (const int e : creases) barrier[std::size_t(e)] = true;
  const auto is_left = [&](int face) {
    double sum = 0.0;
    for (const int v : sheet.corners_of(face)) sum += cut.side(sheet.folded[std::size_t(v)]);
    return sum > 0.0;
  };
  std::vector<int> open;
  for (const int e : creases) {
    for (const int face : {sheet.half(2 * e).face, sheet.half(2 * e + 1).face}) {
      if (face < 0 || !is_left(face) || moving[std::size_t(face)]) continue;
      moving[std::size_t(face)] = true;
      open.push_back(face);
    }
  }
  while (!open.empty()) {
    const int face = open.back();
    open.pop_back();
    for (const int h : sheet.halves_of(face)) {
      const int other = sheet.half(h ^ 1).face;
      if (other < 0 || barrier[std::size_t(h / 2)] || moving[std::size_t(other)]) continue;
      moving[std::size_t(other)] = true;
      open.push_back(other);
    }
  }
  for (const int e : creases) {
    const int a = sheet.half(2 * e).face, b = sheet.half(2 * e + 1).face;
    if (a < 0 || b < 0 || moving[std::size_t(a)] != moving[std::size_t(b)]) continue;
    throw Error(where + ": the line does not part the paper; what moves hangs on what stays");
  }
  return moving;
}

std::vector<int> flaps_of(const Sheet& sheet, const std::vector<bool>& moving,
                          const std::vector<int>& creases) {
  std::vector<bool> barrier(std::size_t(sheet.edges()), false);
  for (const int e : creases) barrier[std::size_t(e)] = true;
  std::vector<int> flap(moving.size(), -1);
  int flaps = 0;
  for (std::size_t first = 0; first < moving.size(); ++first) {
    if (!moving[first] || flap[first] >= 0) continue;
    std::vector<int> open{int(first)};
    flap[first] = flaps;
    while (!open.empty()) {
      const int face = open.back();
      open.pop_back();
      for (const int h : sheet.halves_of(face)) {
        const int other = sheet.half(h ^ 1).face;
        if (other < 0 || barrier[std::size_t(h / 2)] || !moving[std::size_t(other)]) continue;
        if (flap[std::size_t(other)] >= 0) continue;
        flap[std::size_t(other)] = flaps;
        open.push_back(other);
      }
    }
    ++flaps;
  }
  return flap;
}

int outermost_flap(const Sheet& sheet, const std::vector<FaceOrder>& order,
                   const std::vector<int>& flap, int side) {
  const int flaps = 1 + *std::max_element(flap.begin(), flap.end());
  std::vector<bool> covered(std::size_t(flaps), false), covers(std::size_t(flaps), false);
  for (const FaceOrder& o : order) {
    const int a = flap[std::size_t(o.face)], b = flap[std::size_t(o.other)];
    if (a < 0 || b < 0 || a == b) continue;
    const bool a_above = (o.order > 0) == print_is_up(sheet, o.other);
    covered[std::size_t(a_above == (side > 0) ? b : a)] = true;
    covers[std::size_t(a_above == (side > 0) ? a : b)] = true;
  }
  // Of those that lie apart the one that is further to this side.
  std::vector<double> reach(std::size_t(flaps), 0.0), corners(std::size_t(flaps), 0.0);
  for (int f = 0; f < sheet.faces(); ++f) {
    if (flap[std::size_t(f)] < 0) continue;
    const std::size_t k = std::size_t(flap[std::size_t(f)]);
    for (const int v : sheet.corners_of(f)) {
      reach[k] += side * sheet.folded[std::size_t(v)].z();
      corners[k] += 1.0;
    }
  }
  for (std::size_t k = 0; k < reach.size(); ++k) reach[k] /= corners[k];
  const double apart = 1e-9 * size_of(sheet.flat);
  int chosen = -1;
  for (int k = 0; k < flaps; ++k) {
    const std::size_t here = std::size_t(k), best = std::size_t(std::max(chosen, 0));
    if (covered[here]) continue;
    const bool better =
        covers[here] != covers[best] ? covers[here] : reach[here] > reach[best] + apart;
    if (chosen < 0 || better) chosen = k;
  }
  return chosen;
}

}  // namespace hada
