#pragma once

#include <vector>

#include "reconstruct/pixel_level.h"

/// The edges of the extra nodes of a level: where they lie, how they are listed, what they weigh.
namespace hada {

/// A cell of the lattice.
struct Place {
  int row;
  int col;
};

/// The cell that a node is, or that an extra node lies in.
Place place_of(const PixelLevel& level, PixelLevel::Node node);

enum class Way { within, across, along };  // of an edge: in one cell, in a row, in a column
Way way_between(const Place& a, const Place& b);

/// What joins two nodes of a coarser level, a < b and b extra: the sum of the edges in between.
struct EdgeSum {
  PixelLevel::Node a;
  PixelLevel::Node b;
  float weight;
};

/// Lists every sum at the extra nodes that it has.
void list_extra_edges(std::vector<EdgeSum> sums, PixelLevel& coarse);

/// Turns the sums of the edges of extra nodes into edges in series, and counts them in `inverse`;
/// cells with such an edge are no longer even.
void add_extra_edges(PixelLevel& coarse);

}  // namespace hada
