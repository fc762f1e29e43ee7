#include "fit/ridge_moments.h"

#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "synth/synthesize.h"

namespace hada {
namespace {

const Extent extent{160, 160, 0.2, Unit::mm};
const Wrinkle<> plain{.components = {{0.3, 1.0, 0.7, 0.5}, {0.04, 0.5, 0.4, 2.0}},
                      .floor_mm4 = 1e-8};

TEST(RidgeMoments, OfAWaveAreThoseOfASine) {
  // A whole number of waves along x: height and curvature are sines, whose skewness is 0 and whose
  // kurtosis is 1.5. The border is left out: 2 of 200 columns.
  Grid<float> wave(40, 200);
  for (int row = 0; row < 40; ++row) {
    for (int col = 0; col < 200; ++col)
      wave(row, col) = float(std::sin(2.0 * std::numbers::pi * col / 20.0));
  }
  const auto moments = moments_of(ridge_values(wave, Mask(40, 200, 1), 0));
  EXPECT_NEAR(moments[height_skew], 0.0, 0.02);
  EXPECT_NEAR(moments[curvature_skew], 0.0, 0.02);
  EXPECT_NEAR(moments[height_tail], std::log(0.5), 0.02);
  EXPECT_NEAR(moments[curvature_tail], std::log(0.5), 0.02);
}

TEST(RidgeMoments, TurnTheirSignWithTheSheet) {
  auto sheet = synthesize(plain, extent, 5).height;
  const auto up = moments_of(ridge_values(sheet, full_mask(extent), 1));
  for (float& value : sheet) value = -value;
  const auto down = moments_of(ridge_values(sheet, full_mask(extent), 1));
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(up[k], -down[k], 1e-5);
  for (int k = 3; k < 6; ++k) EXPECT_NEAR(up[k], down[k], 1e-5);
}

TEST(RidgeMoments, ReadWhatIsInsideTheMaskOnly) {
  auto sheet = synthesize(plain, extent, 6).height;
  Mask mask = full_mask(extent);
  for (int row = 0; row < 160; ++row) {
    for (int col = 80; col < 160; ++col) mask(row, col) = 0;
  }
  const auto before = moments_of(ridge_values(sheet, mask, 2));
  for (int row = 0; row < 160; ++row) {
    for (int col = 80; col < 160; ++col) sheet(row, col) = 1e6f;
  }
  EXPECT_EQ(before, moments_of(ridge_values(sheet, mask, 2)));
}

TEST(RidgeMoments, ScatterAsTheyAreSaidTo) {
  const double area = extent.width() * extent.height();
  const RidgeScatter scatter = gaussian_scatter(plain, extent, area, 0);
  double sum = 0.0;
  constexpr int sheets = 24;
  for (Seed seed = 0; seed < sheets; ++seed) {
    const auto larger = synthesize(plain, {400, 400, 0.2, Unit::mm}, seed).height;
    const auto cut = crop(larger, 100, 100, extent.rows, extent.cols);
    const auto moments = moments_of(ridge_values(cut, full_mask(extent), 0));
    sum += moments.dot(scatter.llt().solve(moments)) / sheets;
  }
  // A chi-square of six: its mean over 24 sheets has a deviation of sqrt(12 / 24) = 0.7; three of
  // them, and a tenth for what is beyond the first order in 1 / area.
  EXPECT_NEAR(sum, 6.0, 2.7);
}

TEST(RidgeMoments, AreSmoothedUntilNoiseIsAFifth) {
  EXPECT_EQ(smoothings_for({.components = plain.components}, 0.2), 0);
  Wrinkle<> noisy = plain;
  noisy.floor_mm4 = 1e-5;
  const int smoothings = smoothings_for(noisy, 0.2);
  ASSERT_GT(smoothings, 0);
  // Twice as many leave less noise, so that they are enough too; half as many are not.
  EXPECT_EQ(smoothings & (smoothings - 1), 0) << "doubled until it is enough";
  noisy.floor_mm4 = 1e-4;
  EXPECT_GT(smoothings_for(noisy, 0.2), smoothings);
}

}  // namespace
}  // namespace hada
