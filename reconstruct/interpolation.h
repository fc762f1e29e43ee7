#pragma once

#include <cstdint>
#include <vector>

#include "reconstruct/sparse_rows.h"

namespace hada {

/// How the value of every node is made of those of the coarse nodes, which are numbered in order:
/// one row for each, of shares that add up to 1 exactly. No share for nodes without edges.
///
/// The equation of a node is solved for it, with those of the fine nodes that it depends on put in
/// for their values. Of the shares the four largest are kept.
/// Source: H. De Sterck et al., Distance-two interpolation for parallel algebraic multigrid, Numer.
/// Linear Algebra Appl. 15 (2008): extended+i.
SparseRows interpolation(const SparseRows& graph, const std::vector<std::uint8_t>& coarse);

/// The graph of the coarse nodes: P^T A P without its diagonal, its sign changed.
SparseRows coarse_graph(const SparseRows& graph, const SparseRows& interpolation);

}  // namespace hada
