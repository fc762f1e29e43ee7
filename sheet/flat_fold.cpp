#include "sheet/flat_fold.h"

#include <algorithm>
#include <cmath>

namespace hada {
namespace {

using Eigen::Vector2d;

// A movement of the plane: p -> turn (p - from) + to, `turn` a rotation or a reflection.
struct Placement {
  Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
  Vector2d from = Vector2d::Zero();
  Vector2d to = Vector2d::Zero();

  Vector2d operator()(const Vector2d& p) const { return turn * (p - from) + to; }
};

Eigen::Matrix2d reflection_along(const Vector2d& way) {
  const Vector2d u = way.normalized();
  return 2.0 * u * u.transpose() - Eigen::Matrix2d::Identity();
}

}  // namespace

FlatState flat_state(const Sheet& sheet) {
  FlatState state;
  state.vertices.assign(sheet.flat.size(), Vector2d::Zero());
  state.turned.assign(std::size_t(sheet.faces()), false);
  std::vector<bool> placed(sheet.flat.size(), false);
  std::vector<bool> reached(std::size_t(sheet.faces()), false);
  std::vector<Placement> placement(std::size_t(sheet.faces()));
  std::vector<int> queue{0};
  reached[0] = true;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const int face = queue[i];
    const Placement& here = placement[std::size_t(face)];
    for (const int h : sheet.halves_of(face)) {
      const std::size_t v = std::size_t(sheet.origin(h));
      const Vector2d place = here(sheet.flat[v]);
      if (placed[v]) state.gap = std::max(state.gap, (state.vertices[v] - place).norm());
      if (!placed[v]) state.vertices[v] = place;
      placed[v] = true;
      const int other = sheet.half(h ^ 1).face;
      if (other < 0 || reached[std::size_t(other)]) continue;
      reached[std::size_t(other)] = true;
      queue.push_back(other);
      const bool folds = is_folded(sheet.creases[std::size_t(h / 2)]);
      const Vector2d& start = sheet.flat[v];
      const Vector2d way = sheet.flat[std::size_t(sheet.target(h))] - start;
      Placement& there = placement[std::size_t(other)];
      there.turn = folds ? Eigen::Matrix2d(here.turn * reflection_along(way)) : here.turn;
      there.from = start;
      there.to = here(start);
      state.turned[std::size_t(other)] = state.turned[std::size_t(face)] != folds;
    }
  }
  return state;
}

}  // namespace hada
