#pragma once

#include "reconstruct/tile.h"

namespace hada {

/// Sparse Bayesian regression: I = N^T x + e + noise, with a variance gamma_k for each error e_k.
///
/// The evidence is maximised over all gamma (expectation maximisation, 100 rounds); most of them
/// fall to zero, and the samples of the others stop to count. With the flat prior of x the inverse
/// of the evidence's covariance reduces to three unknowns, so that a round costs as much as one of
/// reweighting, with weights 1 / (gamma_k + lambda).
///
/// Source: S. Ikehata, D. Wipf, Y. Matsushita, K. Aizawa, Robust photometric stereo using sparse
/// regression, CVPR 2012, equations 10 to 13; lambda is 1e-6 of the squared albedo.
void fit_sparse_bayesian(Tile& tile);

}  // namespace hada
