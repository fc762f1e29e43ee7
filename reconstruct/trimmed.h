#pragma once

#include "reconstruct/tile.h"

namespace hada {

/// Which ranks of brightness count, as shares of a pixel's samples.
struct RankWindow {
  float low = 0.3f;   // leaves shadows out
  float high = 0.8f;  // leaves highlights out
};

/// Least squares over the samples of a pixel whose rank of brightness lies in the window.
///
/// At least four samples count where there are so many: the window is widened to hold them.
///
/// Source: the position thresholds of B. Shi et al., Bi-polynomial modeling of low-frequency
/// reflectances, TPAMI 36 (2014), and of the trimmed fits in the DiLiGenT benchmark.
void fit_trimmed(Tile& tile, const RankWindow& window = {});

}  // namespace hada
