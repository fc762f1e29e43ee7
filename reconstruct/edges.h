#pragma once

#include "core/surface.h"
#include "reconstruct/slopes.h"

/// What is asked of every pair of neighbours: of a pixel with the one on its right, and the one
/// below. Only pairs inside the mask are read.
namespace hada {

/// How much each pair counts; 0 cuts it apart.
struct EdgeWeights {
  Grid<float> east;
  Grid<float> south;
};

/// How much the height rises from the first pixel to the second, in px.
struct EdgeRises {
  Grid<float> east;
  Grid<float> south;
};

/// The same weights, so scaled that their median inside the mask is 1.
Grid<float> with_median_1(Grid<float> weight, const Mask& mask);

/// The weights of equations between pixels that count as `weight` says, > 0: an equation takes the
/// slope of both pixels, so its variance is the mean of theirs, 1 / weight each.
EdgeWeights edge_weights(const Grid<float>& weight);

/// The mean slope of both pixels of every pair: exact where the surface is quadratic.
EdgeRises rises_of(const SlopeMap& slopes, const Mask& mask);

}  // namespace hada
