#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/grid.h"
#include "reconstruct/coarsest.h"
#include "reconstruct/pixel_level.h"
#include "reconstruct/wavefront.h"

namespace hada {

/// What is to happen after every cycle: how many there were, and the error that is left, in px.
using CycleDone = std::function<void(int cycles, double error)>;

/// Solves A x = right on a graph of pixels, A its Laplacian, matrix-free and in single precision.
///
/// Full multigrid finds a first height, and cycles correct it in place. Its residual is formed from
/// differences of neighbours, since the height of a large surface is rounded more coarsely than a
/// residual may be: both are multiples of one step, so that not a single sum rounds.
///
/// All that a cycle does on a level between two visits of the coarser one runs as one wavefront
/// over the rows, so a cycle costs little more than reading its arrays once. Should cycles alone
/// settle slowly, as on masks like a sieve, each becomes a step of flexible conjugate gradients.
/// Source: W. L. Briggs, V. E. Henson, S. F. McCormick, A multigrid tutorial (2000); Y. Notay,
/// Flexible conjugate gradients, SIAM J. Sci. Comput. 22 (2000).
class Multigrid {
 public:
  explicit Multigrid(PixelLevel finest);

  const PixelLevel& finest() const { return levels_.front(); }
  /// Set before `solve`, which changes it; laid out as the finest level.
  Cells& right() { return levels_.front().right; }

  /// The right-hand side consists of multiples of `step`: the residual is then formed without
  /// rounding. Returns 3 * 2^22 step, which rounds to these multiples when it is added and taken
  /// off again.
  float set_step(float step) { return magic_ = 3.0f * 0x1p22f * step; }

  struct Solution {
    Grid<float> value;  // up to a constant in each region; 0 where there are no pixels
    int cycles = 0;
    double error = 0.0;  // estimate, root mean square over the cells with edges
  };
  /// Cycles until the error is estimated at `tolerance`, or `max_cycles` are done.
  Solution solve(double tolerance, int max_cycles, const CycleDone& done = {});

 private:
  void cycle(std::size_t index);
  void find_first();
  void go_down(std::size_t index, bool from_zero);
  void go_up(std::size_t index);
  void go_up_and_down(std::size_t index);
  void come_back(std::size_t index);
  void run(std::size_t index, const std::vector<Stage>& stages);
  double coarse_size() const;
  void conjugate_steps(double tolerance, int max_cycles, const CycleDone& done, Solution& solution);

  std::vector<PixelLevel> levels_;
  std::optional<CoarsestSolver> coarsest_;
  std::size_t visited_twice_ = 0;  // levels from the second to this one, in a cycle
  float magic_ = 0.0f;
  double cells_ = 0.0;  // with edges, of the finest level
};

}  // namespace hada
