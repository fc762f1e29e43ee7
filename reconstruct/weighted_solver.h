#pragma once

#include "reconstruct/algebraic_multigrid.h"
#include "reconstruct/edges.h"
#include "reconstruct/multigrid.h"

namespace hada {

/// Least-squares heights where every equation counts with a weight of its own.
///
/// On the chessboard of pixels no two red ones are neighbours, so they are eliminated exactly. What
/// is left is a graph of the black ones, of which one cycle of `AlgebraicMultigrid` makes a step of
/// conjugate gradients. The residual is formed anew in every step, from the rises and in double
/// precision: where weights differ, a pull that hardly counts at one pixel decides over a plate
/// that hangs on weak edges alone.
class WeightedSolver {
 public:
  WeightedSolver(const Mask& mask, EdgeWeights weights);

  struct Solution {
    Grid<double> height;  // up to a constant in each region; 0 outside
    int cycles = 0;
  };
  /// Cycles until the root mean square error is estimated at `tolerance`, or `max_cycles` are done.
  Solution solve(const EdgeRises& rises, double tolerance, int max_cycles,
                 const CycleDone& done = {});

 private:
  static bool is_black(int row, int col) { return (row + col) % 2 == 1; }
  template <class Work>
  void for_neighbours(int row, int col, const Work& work) const;
  double held(int row, int col) const;
  SparseRows graph_of_black() const;
  void find_residual(const EdgeRises& rises, const Grid<double>& height,
                     Grid<double>& residual) const;
  void precondition(const Grid<double>& residual, Grid<double>& step);
  double energy(const Grid<double>& step) const;

  const Mask& mask_;
  EdgeWeights weights_;
  Grid<int> index_;  // of a black pixel; -1 elsewhere
  double pixels_ = 0.0;
  AlgebraicMultigrid black_;
};

}  // namespace hada
