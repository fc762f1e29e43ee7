#include "reconstruct/tile_solver.h"

#include <gtest/gtest.h>

#include "tiles.h"

namespace hada {
namespace {

// Of every three pixels one is clean, one has one bad sample and one has two.
Tile mixed_tile(int pixels) {
  Tile tile = matte_tile(ring_of_lights(12), pixels);
  for (int i = 0; i < pixels; ++i) {
    if (i % 3 > 0) tile.grey[tile.at(i % 12, i)] += 0.3f;
    if (i % 3 > 1) tile.grey[tile.at((i + 5) % 12, i)] *= 0.1f;
  }
  return tile;
}

NormalPlan plan_for(const Tile& tile) {
  NormalPlan plan;
  plan.pseudo_inverse = pseudo_inverse_of(tile);
  return plan;
}

TEST(TileSolver, FindsEveryPixelWhateverIsWrongWithIt) {
  Tile tile = mixed_tile(50);
  const NormalPlan plan = plan_for(tile);
  TileSolver(plan, tile, true).solve(tile, true);
  for (int i = 0; i < tile.pixels; ++i) {
    // Nothing but the bad samples is off, so that rounding is left, blown up by the lights.
    EXPECT_LT((found_in(tile, i) - tile_rho * tile_normal(i)).norm(), 1e-6) << i;
    float believed = 0.0f;
    for (int k = 0; k < 12; ++k) believed += tile.weight[tile.at(k, i)];
    EXPECT_NEAR(believed, 12 - i % 3, 0.01) << i;  // 1 - (r / 4.685 s)^2 is 1 but for rounding
  }
}

TEST(TileSolver, GivesTheSameBytesWithoutWeights) {
  Tile with = mixed_tile(45);
  Tile without = with;
  const NormalPlan plan = plan_for(with);
  TileSolver(plan, with, true).solve(with, true);
  TileSolver(plan, without, false).solve(without, true);
  for (int i = 0; i < with.pixels; ++i) EXPECT_EQ(found_in(with, i), found_in(without, i)) << i;
}

}  // namespace
}  // namespace hada
