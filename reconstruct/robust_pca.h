#pragma once

#include "reconstruct/tile.h"

namespace hada {

/// Normals off a matrix of low rank: samples = A + E, A of low rank, E sparse.
///
/// Minimises |A|_* + lambda |E|_1, lambda = 1 / sqrt(pixels), by the inexact method of augmented
/// Lagrange multipliers; samples that may not count are unknown entries, as are those below a
/// twentieth of their pixel's brightest (shadows). Normals are least squares on A, the weight of a
/// sample is 1 where E is 0.
///
/// tile  all pixels that share one matrix: thousands of them, not a handful
///
/// Sources: L. Wu, A. Ganesh, B. Shi, Y. Matsushita, Y. Wang, Y. Ma, Robust photometric stereo via
/// low-rank matrix completion and recovery, ACCV 2010; Z. Lin, M. Chen, Y. Ma, arXiv:1009.5055.
void fit_robust_pca(Tile& tile);

}  // namespace hada
