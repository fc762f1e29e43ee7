#include "synth/gaussian_field.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/parallel.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

/// Variance 4, correlation length about 1.4 mm; e^-98 of its peak at 2.5 cycles per mm.
double smooth(double fx, double fy) {
  return 4.0 * 4.0 * pi * std::exp(-4.0 * pi * pi * (fx * fx + fy * fy));
}

double mean_square(const Grid<float>& field) {
  double sum = 0.0;
  for (const float value : field) sum += double(value) * value;
  return sum / double(field.size());
}

TEST(GaussianField, HasTheVarianceThatItsDensityIntegratesTo) {
  const Extent extent{256, 320, 0.2, Unit::mm};
  const auto field = gaussian_field(smooth, extent, 3);
  // The variance of the mean square is 2 / area times the integral of smooth^2, which is 16 * 2 pi:
  // 2 * 16 * 2 pi / (51.2 * 64) = 0.0614, a deviation of 0.25. Three of them.
  EXPECT_NEAR(mean_square(field), 4.0, 0.75);
}

TEST(GaussianField, HasNoMean) {
  const auto field = gaussian_field(smooth, {128, 128, 0.2, Unit::mm}, 3);
  double sum = 0.0;
  for (const float value : field) sum += value;
  EXPECT_NEAR(sum / double(field.size()), 0.0, 1e-6);
}

TEST(GaussianField, ShowsTheSameFieldAtAFinerPitch) {
  const auto coarse = gaussian_field(smooth, {50, 64, 0.3, Unit::mm}, 11);
  const auto fine = gaussian_field(smooth, {150, 192, 0.1, Unit::mm}, 11);
  for (int row = 0; row < coarse.rows(); ++row) {
    for (int col = 0; col < coarse.cols(); ++col) {
      // Of three fine pixels the middle one has the place of the coarse one. What the coarse grid
      // cannot hold is e^-55 of the density; float rounding of values near 8 remains.
      ASSERT_NEAR(coarse(row, col), fine(3 * row + 1, 3 * col + 1), 1e-5);
    }
  }
}

TEST(GaussianField, IsAnotherFieldForAnotherSeed) {
  const Extent extent{64, 64, 0.2, Unit::mm};
  EXPECT_NE(gaussian_field(smooth, extent, 1), gaussian_field(smooth, extent, 2));
}

TEST(GaussianField, TilesWithoutASeam) {
  const auto field = gaussian_field(smooth, {96, 96, 0.1, Unit::mm}, 5);
  double seam = 0.0, inside = 0.0;
  for (int row = 0; row < 96; ++row) {
    seam += std::pow(field(row, 0) - field(row, 95), 2) / 96;
    inside += std::pow(field(row, 48) - field(row, 47), 2) / 96;
  }
  // Steps of the same law; each mean square rests on about 5 independent stretches.
  EXPECT_LT(seam, 8.0 * inside);
}

TEST(GaussianField, HasTheSameBytesAtAnyThreadCount) {
  const Extent extent{128, 96, 0.2, Unit::mm};
  set_threads(1);
  const auto alone = gaussian_field(smooth, extent, 4);
  set_threads(3);
  const auto shared = gaussian_field(smooth, extent, 4);
  set_threads(0);
  EXPECT_EQ(alone, shared);
}

TEST(GaussianField, KeepsDirections) {
  // Density only where fx and fy have the same sign: crests run down to the right (y up), so that
  // the field changes slowly along (1, -1).
  const auto density = [](double fx, double fy) { return fx * fy > 0.0 ? smooth(fx, fy) : 0.0; };
  const auto field = gaussian_field(density, {128, 128, 0.2, Unit::mm}, 6);
  double down = 0.0, up = 0.0;
  for (int row = 1; row + 1 < 128; ++row) {
    for (int col = 0; col + 1 < 128; ++col) {
      down += std::pow(field(row + 1, col + 1) - field(row, col), 2);
      up += std::pow(field(row - 1, col + 1) - field(row, col), 2);
    }
  }
  EXPECT_LT(down, 0.5 * up);
}

TEST(GaussianField, TakesOddAndTinyGrids) {
  EXPECT_EQ(gaussian_field(smooth, {1, 1, 0.2, Unit::mm}, 1), Grid<float>(1, 1));
  for (const float value : gaussian_field(smooth, {7, 5, 0.2, Unit::mm}, 1))
    EXPECT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace hada
