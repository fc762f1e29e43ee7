#pragma once

#include <optional>
#include <vector>

#include "reconstruct/graph_factors.h"
#include "reconstruct/sparse_rows.h"

namespace hada {

/// Multigrid on any graph with weights: which nodes are kept on a coarser level, and how values
/// are carried there, follow the weights alone, however much they differ.
///
/// A W-cycle with one sweep of Gauss-Seidel down and one, backwards, up: symmetric, so that it can
/// precondition conjugate gradients. In double precision, with the matrices in single.
/// Source: J. W. Ruge, K. Stueben, Algebraic multigrid, in: Multigrid methods (1987).
class AlgebraicMultigrid {
 public:
  using Values = std::vector<double, Memory<double>>;

  explicit AlgebraicMultigrid(SparseRows graph);

  /// Set before `cycle`: one number for each node, of zero sum in every region.
  Values& right() { return levels_.front().right; }
  /// About A^-1 right, up to a constant in each region; 0 at nodes without edges.
  const Values& cycle();

 private:
  struct Level {
    explicit Level(SparseRows level_graph);

    SparseRows graph;
    SparseRows interpolation;  // from the next level
    Values inverse;            // 1 over the sum of all edges at a node, 0 for a lonely one
    Values value, right;
  };
  static void relax(Level& level, bool forwards);
  static void restrict_rest(const Level& level, Level& coarse);
  void visit(std::size_t index);

  std::vector<Level> levels_;
  std::optional<GraphFactors> coarsest_;
};

}  // namespace hada
