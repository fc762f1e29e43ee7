#pragma once

#include <cstddef>
#include <vector>

#include "core/grid.h"

namespace hada {

/// The graph of neighbouring pixels of a mask, with a weight on every edge.
///
/// One ring of empty cells surrounds the grid, so that no loop asks whether a neighbour exists:
/// cell (row, col) is at (row + 1) * stride + col + 1, and edges that are not there weigh 0.
struct PixelGraph {
  int rows = 0;
  int cols = 0;
  std::vector<float> east;     // weight of the edge to the cell on the right
  std::vector<float> south;    // to the cell below
  std::vector<float> inverse;  // 1 / sum of the weights at a cell, 0 for a lonely one

  PixelGraph(int rows, int cols);
  /// Edges of weight 1 between neighbours that both are in `mask`.
  explicit PixelGraph(const Mask& mask);

  std::size_t stride() const { return std::size_t(cols) + 2; }
  std::size_t size() const { return (std::size_t(rows) + 2) * stride(); }
  std::size_t first(int row) const { return (std::size_t(row) + 1) * stride() + 1; }
  void update_inverse();

  /// Sum over the edges at `cell` of weight times the value at the other end.
  template <class T>
  T gather(const std::vector<T>& value, std::size_t cell) const {
    return T(east[cell]) * value[cell + 1] + T(east[cell - 1]) * value[cell - 1] +
           T(south[cell]) * value[cell + stride()] +
           T(south[cell - stride()]) * value[cell - stride()];
  }
};

/// An approximate inverse of the Laplacian of a pixel graph: one multigrid cycle from zero.
///
/// Cells are joined 2 x 2; a coarse edge weighs half of the edges it stands for, which keeps the
/// stiffness of a plate and of a path one pixel wide alike. Red-black Gauss-Seidel, black-red on
/// the way back, and two visits of each coarser level: symmetric, as conjugate gradients ask.
/// Source: Briggs, Henson, McCormick, A multigrid tutorial (2000); the halving of piecewise
/// constant coarse operators: Braess, Computing 55 (1995).
class Multigrid {
 public:
  explicit Multigrid(const Mask& mask);

  const PixelGraph& finest() const { return levels_.front().graph; }
  /// Set before `cycle`: the right-hand side, padded as the finest graph.
  std::vector<float>& right() { return levels_.front().right; }
  /// The result of `cycle`.
  const std::vector<float>& value() const { return levels_.front().value; }
  void cycle() { cycle(0, true); }

 private:
  struct Level {
    PixelGraph graph;
    std::vector<float> value;
    std::vector<float> right;
  };
  void cycle(std::size_t index, bool from_zero);

  std::vector<Level> levels_;
};

}  // namespace hada
