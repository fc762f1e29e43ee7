#pragma once

#include <vector>

#include "reconstruct/pixel_level.h"
#include "reconstruct/wavefront.h"

/// The steps of a multigrid cycle on the cells of one level, as stages of a wavefront: red cells
/// are those with an even sum of row and column. `x` and `right` are laid out as the level is.
namespace hada {

struct System {
  const PixelLevel& level;
  float* x;
  float* right;
  /// Where edges all weigh 1, sweeps round x to multiples of magic / (3 * 2^22), and of magic 0 not
  /// at all. Where `right` consists of such multiples too, so does right - A x, and none of its
  /// sums rounds.
  float magic = 0.0f;
};

/// How far cells move in a sweep, as a multiple of the way to where their equations hold.
struct Relaxation {
  float red = 1.0f;
  float black = 1.0f;
};

/// One sweep of successive over-relaxation, red cells first; of Gauss-Seidel where factors are 1.
void add_sweep(const System& system, const Relaxation& factors, std::vector<Stage>& stages);
/// The same where x is 0; what x holds is not read. Black cells are not over-relaxed.
void add_sweep_from_zero(const System& system, float red_factor, std::vector<Stage>& stages);

/// x += factor * the correction of the coarser level, at black cells: a sweep must follow, and that
/// sets the red ones from the black ones alone, with a factor of 1.
void add_correction(const System& system, const PixelLevel& coarse, float factor,
                    std::vector<Stage>& stages);

/// right of the coarser level = the residual, added up over blocks. A sweep that does not
/// over-relax the black cells must be before it: then their residual is 0, and only that of the red
/// ones is found.
void add_restriction(const System& system, PixelLevel& coarse, std::vector<Stage>& stages);
/// The same of all cells, from differences of neighbours: after any sweep, and for an x that is
/// large.
void add_exact_restriction(const System& system, PixelLevel& coarse, std::vector<Stage>& stages);

/// right of the coarser level = right, added up over blocks: the residual where x is 0.
void add_gathering(const PixelLevel& level, PixelLevel& coarse, std::vector<Stage>& stages);

/// right -= A x, at all cells, from differences of neighbours.
void add_subtraction(const System& system, std::vector<Stage>& stages);

}  // namespace hada
