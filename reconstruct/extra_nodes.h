#pragma once

#include <utility>
#include <vector>

#include "reconstruct/pixel_level.h"

/// What a multigrid cycle does on the extra nodes of a level, one after another: they are few. The
/// cells of the lattice and the extra nodes take turns, each with the others held still.
namespace hada {

void relax_extras(const PixelLevel& level, Cells& x, const Cells& right, bool from_zero);

/// The residual of the extra nodes, added to the right-hand side of their coarser ones.
void restrict_extras(const PixelLevel& level, const Cells& x, const Cells& right,
                     PixelLevel& coarse);

/// The right-hand side of the extra nodes, added to that of their coarser ones.
void gather_extras(const PixelLevel& level, PixelLevel& coarse);

/// x += the correction of the coarser level, at the extra nodes.
void correct_extras(const PixelLevel& level, const PixelLevel& coarse, Cells& x);

/// While it lives, the extra nodes pull at the cells of the lattice through `right`.
class PulledByExtras {
 public:
  PulledByExtras(const PixelLevel& level, const Cells& x, Cells& right);
  ~PulledByExtras();
  PulledByExtras(const PulledByExtras&) = delete;
  PulledByExtras& operator=(const PulledByExtras&) = delete;

 private:
  Cells& right_;
  std::vector<std::pair<std::size_t, float>> was_;
};

}  // namespace hada
