#include "measure/autocorrelation.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

// Waves along x, eight whole periods.
Grid<float> waves(int rows, int cols) {
  Grid<float> map(rows, cols);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      map(row, col) = float(7.0 + std::sin(2.0 * pi * 8.0 * (col + 0.5) / cols));
    }
  }
  return map;
}

TEST(Autocorrelation, OfAWaveIsACosine) {
  const auto map = waves(64, 256);
  const Autocorrelation found(map, Mask(64, 256, 1));
  EXPECT_NEAR(found.at(0, 0).value(), 1.0, 1e-5);
  for (const int lag : {5, 16, 32, -16}) {
    // Pairs over 256 - lag columns are no whole periods: what is left of the mean of the doubled
    // frequency is at most 1 / (2 pi 8) of the variance, by the share of columns.
    EXPECT_NEAR(found.at(lag, 3).value(), std::cos(2.0 * pi * lag / 32.0), 0.024);
  }
}

TEST(Autocorrelation, FallsAfterTheArcCosine) {
  const Autocorrelation found(waves(64, 256), Mask(64, 256, 1));
  // The same error of 0.02 on a slope of 0.98 2 pi / 32 a pixel.
  EXPECT_NEAR(found.length_px(1, 0), 32.0 * std::acos(0.2) / (2.0 * pi), 0.12);
  EXPECT_GE(found.length_px(0, 1), 31.0);  // along the crests it never falls
}

TEST(Autocorrelation, CountsThePairsOfAnyMaskAlike) {
  const auto map = waves(64, 256);
  Mask mask(64, 256, 1);
  mask(63, 255) = 0;  // one pixel in 16384, one pair in 8000 at these lags
  const Autocorrelation whole(map, Mask(64, 256, 1)), part(map, mask);
  for (const int lag : {0, 9, -32, 100})
    EXPECT_NEAR(part.at(lag, 12).value(), whole.at(lag, 12).value(), 1e-3) << lag;
}

TEST(Autocorrelation, LooksCounterClockwise) {
  Grid<float> map(128, 128);
  for (int row = 0; row < 128; ++row) {
    for (int col = 0; col < 128; ++col) map(row, col) = float(std::sin(0.3 * (col + row)));
  }
  // col + row is constant up to the right, at 45 degrees: there it never falls.
  const auto lengths = Autocorrelation(map, Mask(128, 128, 1)).lengths_px(4);
  EXPECT_GT(lengths[1], 5.0 * lengths[3]);
}

TEST(Autocorrelation, DoesNotReadOutsideTheMask) {
  auto map = waves(64, 256);
  Mask mask(64, 256, 1);
  for (int col = 0; col < 64; ++col) {
    mask(10, col) = 0;
    map(10, col) = std::nanf("");
  }
  EXPECT_NEAR(Autocorrelation(map, mask).at(32, 0).value(), 1.0, 0.01);
}

TEST(Autocorrelation, KnowsNothingBeyondHalfASide) {
  EXPECT_FALSE(Autocorrelation(waves(64, 256), Mask(64, 256, 1)).at(130, 0));
}

}  // namespace
}  // namespace hada
