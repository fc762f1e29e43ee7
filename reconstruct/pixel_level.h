#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <vector>

#include "core/grid.h"
#include "reconstruct/dealt.h"
#include "reconstruct/zeroed.h"

namespace hada {

/// One lattice of the multigrid solver: cells, the edges between them, and a linear system on them.
///
/// A cell of a coarse lattice stands for a block of 2 x 2 cells that hang together. Where a block
/// falls into parts, by a slit or by edges that hardly count, the largest part becomes the cell and
/// each of the others an extra node beside the lattice, with a list of its edges. Without them, two
/// sides of a slit would be moved as one.
struct PixelLevel {
  using Node = std::int32_t;  // a cell's place in `Dealt`, or at.size() + index of an extra node

  explicit PixelLevel(std::pmr::memory_resource* where = nullptr)
      : value(where),
        right(where),
        code(where),
        east(where),
        south(where),
        inverse(where),
        reach_across(where),
        reach_along(where),
        even(where) {}
  std::pmr::memory_resource* memory() const { return value.get_allocator().resource; }

  Dealt at;
  /// Of both blocks of every row, the cells from the first to the last that there are, in whole
  /// sixteens. What lies around an object is neither worked on nor touched, and stays 0.
  struct Stretch {
    int first = 0;
    int last = 0;  // one beyond
  };
  std::vector<Stretch> stretches;  // empty: all cells of every row
  Cells value;
  Cells right;  // right-hand side; sums to 0 in every region

  // The finest level of a plain mask: a byte for each pixel, see row_kernels.h, and nothing else.
  std::vector<std::uint8_t, Zeroed<std::uint8_t>> code;
  // All others: the weight of the edge to the right and below, 1 over the sum of all at a cell, and
  // the reach of a cell along rows and columns, 1 / (2 sum of the edges that join its two halves).
  Cells east, south, inverse;
  Cells reach_across, reach_along;
  // 1 for the cells of a coarse lattice that are as all are in an even one: four edges of weight 1,
  // a reach of 1/4. Empty: not looked for.
  std::vector<std::uint8_t, Zeroed<std::uint8_t>> even;

  struct Edge {
    Node to;
    float weight;
  };
  struct Extra {
    int row, col;  // of the cell that it lies in
    float reach_across, reach_along;
    int first_edge;  // in `edges`; they end where those of the next begin
    Node parent = 0;
  };
  std::vector<Extra> extras;  // sorted by (row, col)
  std::vector<Edge> edges;

  // Cells that belong to an extra node of the next level instead of to the cell of their block,
  // sorted by (row, parity, place).
  struct Moved {
    int row;
    Node cell;
    Node parent;
  };
  std::vector<Moved> moved;

  Stretch stretch(int row) const {
    return stretches.empty() ? Stretch{0, at.block} : stretches[std::size_t(row)];
  }
  /// The cells of a row that are in its stretch and have this parity of columns.
  HalfRow half_row(int row, int parity) const {
    const auto [first, last] = stretch(row);
    return {row, parity, first, last - first};
  }
  bool unit() const { return !code.empty(); }
  bool is_extra(Node node) const { return node >= Node(at.size()); }
  std::size_t nodes() const { return at.size() + extras.size(); }
  int last_edge(std::size_t extra) const {
    return extra + 1 < extras.size() ? extras[extra + 1].first_edge : int(edges.size());
  }

  /// The finest level of a mask, all edges of weight 1, in the memory of the mask.
  static PixelLevel of(const Mask& mask);
};

}  // namespace hada
