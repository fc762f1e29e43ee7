#include "reconstruct/noise.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

// Residuals of `freedom` independent samples at each pixel.
Residuals residuals_of(int size, int freedom, double noise) {
  Residuals residuals{Grid<float>(size, size), Grid<float>(size, size, float(freedom))};
  for (std::size_t i = 0; i < residuals.squares.size(); ++i) {
    for (int k = 0; k < freedom; ++k) {
      residuals.squares[i] += float(std::pow(noise * gaussian(3, std::int64_t(i), k), 2));
    }
  }
  return residuals;
}

TEST(TypicalNoise, IsThatOfTheSamplesForAnyNumberOfThem) {
  for (const int freedom : {1, 2, 5, 9}) {
    // The median of 10^4 variances is good to 1.3 % or better; the closed form for one degree of
    // freedom errs by 2 %.
    EXPECT_NEAR(typical_noise(residuals_of(100, freedom, 0.01)), 0.01, 0.0003) << freedom;
  }
}

TEST(TypicalNoise, DoesNotCountPixelsAtWhichTheModelFails) {
  Residuals residuals = residuals_of(100, 5, 0.01);
  for (int row = 0; row < 10; ++row) {
    for (float& squares : residuals.squares.row(row)) squares = 1.0f;
  }
  // A tenth of outliers moves the median to the 55.6th percentile: 8 % of the variance.
  EXPECT_NEAR(typical_noise(residuals), 0.01, 0.0005);
}

TEST(TypicalNoise, IsThePriorWhereNothingIsLeftOver) {
  EXPECT_EQ(typical_noise(residuals_of(10, 0, 0.01)), prior_noise);
}

TEST(LocalVariance, GrowsWhereTheModelFails) {
  Residuals residuals = residuals_of(60, 5, 0.01);
  for (int row = 0; row < 20; ++row) {
    for (float& squares : residuals.squares.row(row)) squares = 5.0f * 0.05f * 0.05f;
  }
  const Grid<float> variance = local_variance(residuals, 0.01);
  // 81 pixels of 5 residuals against 20 of the prior: within 5 % of the local variance 0.0025.
  EXPECT_NEAR(variance(10, 30), 0.0025, 0.05 * 0.0025);
  // 425 degrees of freedom: the variance is good to 7 %; three times that.
  EXPECT_NEAR(variance(50, 30), 1e-4, 0.21e-4);
}

}  // namespace
}  // namespace hada
