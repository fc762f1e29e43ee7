#pragma once

#include <cstdint>
#include <vector>

#include "reconstruct/sparse_rows.h"

namespace hada {

/// The heaviest edge of every node, 0 where there is none.
std::vector<float> heaviest_edges(const SparseRows& graph);

/// A node depends on another where their edge weighs at least this share of its heaviest one.
constexpr float strong_share = 0.25f;

inline bool is_strong(float weight, float heaviest) {
  return weight > 0.0f && weight >= strong_share * heaviest;
}

/// 1 for the nodes of the graph that the coarser level keeps: every other node with edges depends
/// on at least one of them, and as few as can be depend on each other.
///
/// Source: J. W. Ruge, K. Stueben, Algebraic multigrid, in: Multigrid methods (1987), first pass.
std::vector<std::uint8_t> coarse_nodes(const SparseRows& graph);

}  // namespace hada
