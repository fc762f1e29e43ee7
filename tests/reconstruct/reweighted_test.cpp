#include "reconstruct/reweighted.h"

#include <gtest/gtest.h>

#include "tiles.h"

namespace hada {
namespace {

constexpr double rounding = 1e-6;  // as in the tests of least squares

// One sample of twelve is wrong by half an albedo.
Tile spoiled_tile() {
  Tile tile = matte_tile(ring_of_lights(12), 20);
  for (int i = 0; i < tile.pixels; ++i) tile.grey[tile.at(i % 12, i)] += 0.3f;
  return tile;
}

double largest_error(const Tile& tile) {
  double most = 0.0;
  for (int i = 0; i < tile.pixels; ++i) {
    most = std::max(most, (found_in(tile, i) - tile_rho * tile_normal(i)).norm());
  }
  return most;
}

TEST(FitBiweight, BelievesNothingOfASampleFarOff) {
  Tile tile = spoiled_tile();
  fit_biweight(tile);
  EXPECT_LT(largest_error(tile), rounding);
  for (int i = 0; i < tile.pixels; ++i) {
    EXPECT_EQ(tile.weight[tile.at(i % 12, i)], 0.0f);
    EXPECT_GT(tile.weight[tile.at((i + 1) % 12, i)], 0.99f);
  }
}

TEST(FitBiweight, IsLeastSquaresWithTooFewSamplesToJudgeBy) {
  Tile tile = matte_tile(ring_of_lights(5), 8);
  tile.grey[tile.at(1, 4)] += 0.2f;
  fit_biweight(tile);
  const Eigen::Vector3d truth = reference_fit(tile, 4, [](int) { return true; });
  EXPECT_LT((found_in(tile, 4) - truth).norm(), rounding);
}

TEST(RefitBiweight, StaysAtTheAnswerItStartsFrom) {
  Tile tile = spoiled_tile();
  fit_biweight(tile);
  const Tile before = tile;
  refit_biweight(tile);
  for (int i = 0; i < tile.pixels; ++i) {
    EXPECT_LT((found_in(tile, i) - found_in(before, i)).norm(), rounding);
  }
}

TEST(Reweighting, BoundsWhatOneSampleCanDo) {
  // The scale falls to its floor of 0.002 rho. There the sums of w l r balance: the wrong sample
  // pulls by 1.345 s (Huber), by less than 2.385 s / 2 (Cauchy) or by as much as one sign among
  // twelve (l1), against a stiffness of at least the smallest eigenvalue of N^T N, above 2 here.
  const double floor = 0.002 * tile_rho;
  Tile huber = spoiled_tile();
  fit_huber(huber);
  EXPECT_LT(largest_error(huber), 1.345 * floor);
  Tile cauchy = spoiled_tile();
  fit_cauchy(cauchy);
  EXPECT_LT(largest_error(cauchy), 2.385 * floor);
  Tile l1 = spoiled_tile();
  fit_l1(l1);
  EXPECT_LT(largest_error(l1), floor);
}

}  // namespace
}  // namespace hada
