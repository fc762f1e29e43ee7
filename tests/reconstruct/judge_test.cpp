#include "reconstruct/judge.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "reconstruct/least_squares.h"
#include "tiles.h"

namespace hada {
namespace {

TEST(Judge, TellsWhatTheFitToAllOthersMisses) {
  Tile tile = matte_tile(ring_of_lights(8), 8);
  for (int i = 0; i < tile.pixels; ++i) {
    for (int k = 0; k < 8; ++k) tile.grey[tile.at(k, i)] += 0.02f * float(uniform(5, i, k) - 0.5);
  }
  fit_least_squares(tile);
  Judgement judgement(8, 8);
  std::vector<float> inside(8, 0.0f);
  inside[3] = 1.0f;
  judge(tile, std::vector<float>(8, 0.0f), inside, judgement);
  double squares = 0.0;
  for (int k = 0; k < 8; ++k) {
    const auto light = std::size_t(k);
    const Eigen::Vector3d l(tile.x_to[light], tile.y_to[light], tile.z_to[light]);
    const double value = tile.grey[tile.at(k, 3)];
    const double used = value - found_in(tile, 3).dot(l);
    const double missed = value - reference_fit(tile, 3, [&](int j) { return j != k; }).dot(l);
    squares += used * used;
    // Residuals of some 0.005 are differences of floats of about 0.5: 1e-5 of themselves, squared.
    EXPECT_NEAR(judgement.used[light], used * used, 1e-7);
    EXPECT_NEAR(judgement.left_out[light], missed * missed, 1e-7);
    EXPECT_NEAR(judgement.picture[light], value * value, 1e-6);
  }
  EXPECT_NEAR(judgement.squares[3], squares, 1e-7);
  EXPECT_EQ(judgement.freedom[3], 5.0f);
  EXPECT_EQ(judgement.inliers[3], 8.0f);
}

TEST(Judge, CarriesNoiseOnToTheNormalAndTheAlbedo) {
  Tile tile = matte_tile(ring_of_lights(6), 8);
  fit_least_squares(tile);
  Judgement judgement(6, 8);
  judge(tile, std::vector<float>(6, 0.0f), std::vector<float>(8, 1.0f), judgement);
  const std::vector<float> matrix = pseudo_inverse_of(tile);
  // The covariance of rho n is N^+ N^+^T for a sample variance of 1.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < 6; ++k) {
    const Eigen::Vector3d column(matrix[k], matrix[6 + k], matrix[12 + k]);
    covariance += column * column.transpose();
  }
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d n = tile_normal(i);
    const double along = n.dot(covariance * n);
    const double rho_squared = tile_rho * tile_rho;
    EXPECT_NEAR(judgement.noise_gain[std::size_t(i)],
                (covariance.trace() - along) / (2.0 * rho_squared), 1e-5);
    EXPECT_NEAR(judgement.albedo_gain[std::size_t(i)], along / rho_squared, 1e-5);
    EXPECT_EQ(judgement.light_variance[std::size_t(i)], 0.0f);
  }
}

}  // namespace
}  // namespace hada
