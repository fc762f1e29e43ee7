#include "reconstruct/sparse_bayesian.h"

#include <gtest/gtest.h>

#include "tiles.h"

namespace hada {
namespace {

TEST(FitSparseBayesian, IsExactWithoutErrors) {
  Tile tile = matte_tile(ring_of_lights(10), 17);
  fit_sparse_bayesian(tile);
  for (int i = 0; i < tile.pixels; ++i) {
    EXPECT_LT((found_in(tile, i) - tile_rho * tile_normal(i)).norm(), 1e-4);
  }
}

TEST(FitSparseBayesian, StopsCountingSamplesThatAreFarOff) {
  Tile tile = matte_tile(ring_of_lights(16), 16);
  for (int i = 0; i < tile.pixels; ++i) {
    tile.grey[tile.at(i, i)] = 0.0f;              // a shadow
    tile.grey[tile.at((i + 6) % 16, i)] += 0.8f;  // a highlight
  }
  fit_sparse_bayesian(tile);
  for (int i = 0; i < tile.pixels; ++i) {
    // Least squares would turn by some 0.1; what still counts of an error of 0.8 is lambda over
    // gamma, 1e-6 of the squared albedo over 0.6.
    EXPECT_LT((found_in(tile, i) - tile_rho * tile_normal(i)).norm(), 1e-3);
    EXPECT_LT(tile.weight[tile.at((i + 6) % 16, i)], 0.1f * tile.weight[tile.at((i + 3) % 16, i)]);
  }
}

}  // namespace
}  // namespace hada
