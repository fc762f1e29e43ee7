#include "reconstruct/trimmed.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tiles.h"

namespace hada {
namespace {

int counted(const Tile& tile, int pixel) {
  int count = 0;
  for (int k = 0; k < tile.lights; ++k) count += tile.weight[tile.at(k, pixel)] == 1.0f;
  return count;
}

TEST(FitTrimmed, CountsTheRanksOfTheWindow) {
  Tile tile = matte_tile(ring_of_lights(12), 19);
  tile.grey[tile.at(4, 6)] = 3.0f;
  tile.grey[tile.at(5, 6)] = 0.0f;
  fit_trimmed(tile);
  for (int i = 0; i < tile.pixels; ++i) {
    // From ceil(0.3 * 12) = 4 to below ceil(0.8 * 12) = 10.
    EXPECT_EQ(counted(tile, i), 6);
    // Floats of 6e-8 under lights whose condition is below 20, for six neighbours in brightness.
    EXPECT_LT((found_in(tile, i) - tile_rho * tile_normal(i)).norm(), 1e-5);
  }
  EXPECT_EQ(tile.weight[tile.at(4, 6)], 0.0f);
  EXPECT_EQ(tile.weight[tile.at(5, 6)], 0.0f);
}

TEST(FitTrimmed, WidensTheWindowToFourSamples) {
  Tile tile = matte_tile(ring_of_lights(5), 8);
  fit_trimmed(tile, {.low = 0.4f, .high = 0.6f});
  for (int i = 0; i < tile.pixels; ++i) EXPECT_GE(counted(tile, i), 4);
}

}  // namespace
}  // namespace hada
