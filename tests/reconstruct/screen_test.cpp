#include "reconstruct/screen.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "reconstruct/least_squares.h"
#include "tiles.h"

namespace hada {
namespace {

// No noise is stated, so that a sigma is what `least_sigma` leaves: a five-hundredth of the albedo.
constexpr float sigma = 0.002f * float(tile_rho);
constexpr double rounding = 1e-6;  // as in the tests of least squares

TEST(Screen, DoubtsWhatTheNoiseDoesNotExplain) {
  Tile tile = matte_tile(ring_of_lights(12), 20);
  // Of one sample that is off by e, least squares leaves (1 - h) e, with h = 3 / 12 in the mean and
  // between 0.1 and 0.4 on this ring.
  tile.grey[tile.at(3, 4)] += 6.0f * sigma;
  tile.grey[tile.at(3, 9)] += 2.0f * sigma;
  tile.trust[tile.at(7, 12)] = 0.0f;
  fit_pseudo_inverse(tile, pseudo_inverse_of(tile));
  std::vector<std::uint8_t> doubtful;
  screen(tile, doubtful);
  for (int i = 0; i < tile.pixels; ++i) {
    EXPECT_EQ(doubtful[std::size_t(i)], i == 4 || i == 12) << i;
  }
}

TEST(Screen, DoubtsANormalThatLooksAwayFromALight) {
  Tile tile = matte_tile(ring_of_lights(8), 8);
  for (int k = 0; k < 8; ++k) {
    const auto i = std::size_t(k);
    tile.grey[tile.at(k, 2)] = 0.9f * tile.x_to[i] + 0.1f * tile.z_to[i];  // below 0 for some
  }
  fit_pseudo_inverse(tile, pseudo_inverse_of(tile));
  std::vector<std::uint8_t> doubtful;
  screen(tile, doubtful);
  EXPECT_EQ(doubtful[1], 0);
  EXPECT_EQ(doubtful[2], 1);
}

TEST(DropWorst, IsLeastSquaresWithoutTheSampleThatIsWrong) {
  Tile tile = matte_tile(ring_of_lights(12), 24);
  for (int i = 0; i < tile.pixels; ++i) {
    tile.grey[tile.at(i % 12, i)] += i < 12 ? 0.4f : -0.3f;
    for (int k = 0; k < 12; ++k) {
      tile.grey[tile.at(k, i)] += sigma * float(uniform(3, i, k) - 0.5);  // the others' noise
    }
  }
  const std::vector<float> matrix = pseudo_inverse_of(tile);
  fit_pseudo_inverse(tile, matrix);
  std::vector<std::uint8_t> doubtful;
  drop_worst(tile, matrix, doubtful);
  for (int i = 0; i < tile.pixels; ++i) {
    const Eigen::Vector3d truth = reference_fit(tile, i, [&](int k) { return k != i % 12; });
    EXPECT_LT((found_in(tile, i) - truth).norm(), rounding);
    EXPECT_EQ(doubtful[std::size_t(i)], 0);
    for (int k = 0; k < 12; ++k) EXPECT_EQ(tile.weight[tile.at(k, i)], k == i % 12 ? 0.0f : 1.0f);
  }
}

TEST(DropWorst, StillDoubtsPixelsWithTwoBadSamples) {
  Tile tile = matte_tile(ring_of_lights(12), 8);
  tile.grey[tile.at(2, 3)] += 0.4f;
  tile.grey[tile.at(7, 3)] -= 0.3f;
  const std::vector<float> matrix = pseudo_inverse_of(tile);
  fit_pseudo_inverse(tile, matrix);
  std::vector<std::uint8_t> doubtful;
  drop_worst(tile, matrix, doubtful);
  for (int i = 0; i < tile.pixels; ++i) EXPECT_EQ(doubtful[std::size_t(i)], i == 3);
}

}  // namespace
}  // namespace hada
