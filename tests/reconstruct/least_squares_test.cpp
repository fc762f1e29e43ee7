#include "reconstruct/least_squares.h"

#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tiles.h"

namespace hada {
namespace {

// Samples are floats (6e-8) that the condition of the lights (below 3) blows up.
constexpr double rounding = 1e-6;

TEST(FitLeastSquares, LeavesOutWhatMayNotCount) {
  Tile tile = matte_tile(ring_of_lights(7), 21);
  for (int i = 0; i < tile.pixels; ++i) {
    tile.grey[tile.at(i % 7, i)] = 5.0f;
    tile.trust[tile.at(i % 7, i)] = 0.0f;
  }
  fit_least_squares(tile);
  for (int i = 0; i < tile.pixels; ++i) {
    EXPECT_LT((found_in(tile, i) - tile_rho * tile_normal(i)).norm(), rounding);
    EXPECT_EQ(tile.weight[tile.at(i % 7, i)], 0.0f);
    EXPECT_EQ(tile.weight[tile.at((i + 1) % 7, i)], 1.0f);
  }
}

TEST(FitLeastSquares, ReturnsNothingForLightsInOnePlane) {
  Tile tile = matte_tile(ring_of_lights(4), 8);
  for (const int k : {1, 3}) tile.trust[tile.at(k, 5)] = 0.0f;
  fit_least_squares(tile);
  EXPECT_EQ(found_in(tile, 5).norm(), 0.0);
  EXPECT_GT(found_in(tile, 4).norm(), 0.5);
}

TEST(FitLeastSquares, ReturnsNothingForASingleSample) {
  // Of one direction the determinants are rounding, of either sign.
  for (int turn = 0; turn < 200; ++turn) {
    std::vector<Light> lights = ring_of_lights(8);
    const Eigen::AngleAxisd by(0.005 * turn, Eigen::Vector3d(1.0, 2.0, 0.5).normalized());
    for (Light& light : lights) light.direction = by * light.direction;
    Tile tile = matte_tile(lights, 8);
    for (int i = 0; i < tile.pixels; ++i) {
      for (int k = 0; k < 8; ++k) tile.trust[tile.at(k, i)] = k == i ? 1.0f : 0.0f;
    }
    fit_least_squares(tile);
    for (int i = 0; i < tile.pixels; ++i) EXPECT_EQ(found_in(tile, i).norm(), 0.0) << turn << i;
  }
}

TEST(FitPseudoInverse, AgreesWithLeastSquaresInDoublePrecision) {
  Tile tile = matte_tile(ring_of_lights(9), 30);
  for (int i = 0; i < tile.pixels; ++i) tile.grey[tile.at(i % 9, i)] += 0.3f;
  fit_pseudo_inverse(tile, pseudo_inverse_of(tile));
  for (int i = 0; i < tile.pixels; ++i) {
    const Eigen::Vector3d truth = reference_fit(tile, i, [](int) { return true; });
    EXPECT_LT((found_in(tile, i) - truth).norm(), rounding);
  }
}

TEST(FitPseudoInverse, GivesTheSameBytesStraightFromThePictures) {
  const std::vector<Light> lights = ring_of_lights(12);
  for (const int pixels : {8, 9, 15, 16, 17, 31, 40, 61}) {
    Tile filled = matte_tile(lights, pixels);
    std::vector<std::vector<float>> pictures;
    GreyRows rows;
    for (int k = 0; k < 12; ++k) {
      const float strength = 0.7f + 0.05f * float(k);
      const auto begin = filled.grey.begin() + std::ptrdiff_t(filled.at(k, 0));
      pictures.emplace_back(begin, begin + pixels);
      for (int i = 0; i < pixels; ++i) filled.grey[filled.at(k, i)] *= strength;
      rows.scale.push_back(strength);
    }
    for (const auto& picture : pictures) rows.values.push_back(picture.data());
    const std::vector<float> matrix = pseudo_inverse_of(filled);
    Tile direct = filled;
    fit_pseudo_inverse(filled, matrix);
    fit_pseudo_inverse(rows, pixels, matrix, direct);
    for (int i = 0; i < pixels; ++i) EXPECT_EQ(found_in(direct, i), found_in(filled, i)) << pixels;
  }
}

}  // namespace
}  // namespace hada
