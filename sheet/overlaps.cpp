#include "sheet/overlaps.h"

#include <bit>

#include "sheet/arrangement.h"

namespace hada {

std::vector<int> BitSet::members() const {
  std::vector<int> all;
  for (std::size_t k = 0; k < words_.size(); ++k) {
    for (std::uint64_t word = words_[k]; word != 0; word &= word - 1) {
      all.push_back(int(64 * k) + std::countr_zero(word));
    }
  }
  return all;
}

Overlaps overlaps(const Sheet& sheet, const FlatState& state) {
  std::vector<std::array<int, 2>> lines;
  for (int e = 0; e < sheet.edges(); ++e) {
    lines.push_back({sheet.origin(2 * e), sheet.target(2 * e)});
  }
  const auto cut =
      arrangement(state.vertices, lines, snap_distance(state.vertices, lines, state.gap));
  Overlaps result;
  result.sides_of = cut.cells_of;
  result.edges_of.resize(cut.segments.size());
  for (int e = 0; e < sheet.edges(); ++e) {
    for (const int s : cut.segments_of[std::size_t(e)]) {
      result.edges_of[std::size_t(s)].push_back(e);
    }
  }
  const int cells = int(cut.cells.size());
  std::vector<std::vector<int>> around(std::size_t(cells) + 1);  // segments; outside is the last
  const auto slot = [&](int cell) { return std::size_t(cell < 0 ? cells : cell); };
  for (std::size_t s = 0; s < cut.segments.size(); ++s) {
    for (const int cell : cut.cells_of[s]) around[slot(cell)].push_back(int(s));
  }
  // Across a segment, the faces that end on it come or go; all others stay.
  std::vector<BitSet> faces(std::size_t(cells) + 1, BitSet(sheet.faces()));
  std::vector<bool> reached(std::size_t(cells) + 1, false);
  std::vector<int> queue{-1};
  reached[slot(-1)] = true;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const int cell = queue[i];
    for (const int s : around[slot(cell)]) {
      const auto [left, right] = cut.cells_of[std::size_t(s)];
      const int other = left == cell ? right : left;
      if (reached[slot(other)]) continue;
      reached[slot(other)] = true;
      queue.push_back(other);
      BitSet& set = faces[slot(other)] = faces[slot(cell)];
      for (const int e : result.edges_of[std::size_t(s)]) {
        for (const int h : {2 * e, 2 * e + 1}) {
          if (sheet.half(h).face >= 0) set.toggle(sheet.half(h).face);
        }
      }
    }
  }
  faces.pop_back();
  result.faces_of = std::move(faces);
  result.cells_of.assign(std::size_t(sheet.faces()), BitSet(cells));
  for (int cell = 0; cell < cells; ++cell) {
    for (const int face : result.faces_of[std::size_t(cell)].members()) {
      result.cells_of[std::size_t(face)].toggle(cell);
    }
  }
  return result;
}

}  // namespace hada
