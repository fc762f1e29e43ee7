#include "reconstruct/robust_pca.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "tiles.h"

namespace hada {
namespace {

TEST(FitRobustPca, SeparatesSparseErrorsFromTheShading) {
  Tile tile = matte_tile(ring_of_lights(16), 2000);
  for (int k = 0; k < tile.lights; ++k) {
    for (int i = 0; i < tile.pixels; ++i) {
      if (uniform(21, k, i) < 0.04) tile.grey[tile.at(k, i)] += 0.5f;
    }
  }
  fit_robust_pca(tile);
  double sum = 0.0;
  for (int i = 0; i < tile.pixels; ++i) {
    sum += (found_in(tile, i) - tile_rho * tile_normal(i)).norm() / tile.pixels;
  }
  // Errors of 0.5 on 4 % of 16 samples, each of which turns least squares by some 0.5 / 5.
  EXPECT_LT(sum, 0.005);
}

TEST(FitRobustPca, FillsSamplesThatMayNotCount) {
  Tile tile = matte_tile(ring_of_lights(12), 1000);
  for (int i = 0; i < tile.pixels; ++i) {
    tile.grey[tile.at(i % 12, i)] = 1.0f;
    tile.trust[tile.at(i % 12, i)] = 0.0f;
  }
  fit_robust_pca(tile);
  for (int i = 0; i < tile.pixels; i += 97) {
    EXPECT_LT((found_in(tile, i) - tile_rho * tile_normal(i)).norm(), 0.01);
  }
}

}  // namespace
}  // namespace hada
