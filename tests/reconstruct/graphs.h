#pragma once

#include <functional>

#include "reconstruct/sparse_rows.h"

namespace hada {

/// The graph of a lattice, node row * cols + col; weight(row, col, down) is that of the edge to the
/// node on the right, or below.
inline SparseRows lattice_graph(int rows, int cols,
                                const std::function<float(int, int, bool)>& weight) {
  SparseRows graph(rows * cols);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const int node = row * cols + col;
      if (row > 0) graph.add(node - cols, weight(row - 1, col, true));
      if (col > 0) graph.add(node - 1, weight(row, col - 1, false));
      if (col + 1 < cols) graph.add(node + 1, weight(row, col, false));
      if (row + 1 < rows) graph.add(node + cols, weight(row, col, true));
      graph.end_row();
    }
  }
  return graph;
}

}  // namespace hada
