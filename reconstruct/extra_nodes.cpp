#include "reconstruct/extra_nodes.h"

#include <algorithm>

namespace hada {
namespace {

// work(extra, its node, first and last of its edges)
template <class Work>
void for_extras(const PixelLevel& level, const Work& work) {
  for (std::size_t i = 0; i < level.extras.size(); ++i) {
    const auto* const edges = level.edges.data();
    work(level.extras[i], level.at.size() + i, edges + level.extras[i].first_edge,
         edges + level.last_edge(i));
  }
}

// Whether a cell of the lattice is red, and the node of the coarser level that it belongs to.
std::pair<bool, std::size_t> colour_and_parent(const PixelLevel& level, const PixelLevel& coarse,
                                               PixelLevel::Node cell) {
  const auto stride = level.at.stride();
  const int row = int(cell / stride) - 1;
  const auto place = cell % stride;
  const int col = int(place < level.at.block ? 2 * place : 2 * (place - level.at.block) + 1);
  const auto moved = std::lower_bound(level.moved.begin(), level.moved.end(), cell,
                                      [](const auto& m, PixelLevel::Node c) { return m.cell < c; });
  const bool has_moved = moved != level.moved.end() && moved->cell == cell;
  return {(row + col) % 2 == 0,
          has_moved ? std::size_t(moved->parent) : std::size_t(coarse.at.cell(row / 2, col / 2))};
}

}  // namespace

void relax_extras(const PixelLevel& level, Cells& x, const Cells& right, bool from_zero) {
  for_extras(level, [&](const auto&, std::size_t node, const auto* edge, const auto* end) {
    float sum = right[node];
    for (; edge != end; ++edge) {
      if (!from_zero || level.is_extra(edge->to)) sum += edge->weight * x[std::size_t(edge->to)];
    }
    x[node] = sum * level.inverse[node];
  });
}

void restrict_extras(const PixelLevel& level, const Cells& x, const Cells& right,
                     PixelLevel& coarse) {
  for_extras(level, [&](const auto& extra, std::size_t node, const auto* edge, const auto* end) {
    if (level.inverse[node] == 0.0f) return;
    float rest = right[node];
    for (; edge != end; ++edge) {
      const auto to = std::size_t(edge->to);
      rest += edge->weight * (x[to] - x[node]);
      if (level.is_extra(edge->to)) continue;
      // `PulledByExtras` pulled with the value of the extra node alone, and the residual of a red
      // cell was found from the edges in the lattice: what is missing is the cell's own part.
      const auto [red, parent] = colour_and_parent(level, coarse, edge->to);
      if (red) coarse.right[parent] -= edge->weight * x[to];
    }
    coarse.right[std::size_t(extra.parent)] += rest;
  });
}

void gather_extras(const PixelLevel& level, PixelLevel& coarse) {
  for_extras(level, [&](const auto& extra, std::size_t node, const auto*, const auto*) {
    coarse.right[std::size_t(extra.parent)] += level.right[node];
  });
}

void correct_extras(const PixelLevel& level, const PixelLevel& coarse, Cells& x) {
  for_extras(level, [&](const auto& extra, std::size_t node, const auto*, const auto*) {
    if (level.inverse[node] > 0.0f) x[node] += coarse.value[std::size_t(extra.parent)];
  });
}

PulledByExtras::PulledByExtras(const PixelLevel& level, const Cells& x, Cells& right)
    : right_(right) {
  for_extras(level, [&](const auto&, std::size_t node, const auto* edge, const auto* end) {
    for (; edge != end; ++edge) {
      if (level.is_extra(edge->to)) continue;
      const auto cell = std::size_t(edge->to);
      was_.emplace_back(cell, right[cell]);
      right[cell] += edge->weight * x[node];
    }
  });
}

PulledByExtras::~PulledByExtras() {
  // Backwards: a cell may be pulled more than once.
  for (auto was = was_.rbegin(); was != was_.rend(); ++was) right_[was->first] = was->second;
}

}  // namespace hada
