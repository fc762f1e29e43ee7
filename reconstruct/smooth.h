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
};

/// One sweep of Gauss-Seidel, red cells first.
void add_sweep(const System& system, std::vector<Stage>& stages);
/// The same where x is 0; what x holds is not read.
void add_sweep_from_zero(const System& system, std::vector<Stage>& stages);

/// x += the correction of the coarser level, at black cells: a sweep must follow, and that sets the
/// red ones from the black ones alone.
void add_correction(const System& system, const PixelLevel& coarse, std::vector<Stage>& stages);

/// right of the coarser level = the residual, added up over blocks. A sweep must be before it: then
/// the residual of the black cells is 0, and only that of the red ones is found.
void add_restriction(const System& system, PixelLevel& coarse, std::vector<Stage>& stages);

/// x is rounded to a multiple of magic / (3 * 2^22), at all cells.
void add_rounding(const System& system, float magic, std::vector<Stage>& stages);

/// total += x, or total = x.
void add_to_total(const System& system, float* total, bool from_zero, std::vector<Stage>& stages);

/// right -= A x, at all cells.
void add_subtraction(const System& system, std::vector<Stage>& stages);

/// right of the coarser level = right, added up over blocks: the problem as the coarser level sees
/// it.
void restrict_right(const PixelLevel& level, PixelLevel& coarse);

}  // namespace hada
