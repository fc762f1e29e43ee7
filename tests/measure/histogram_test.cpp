#include "measure/histogram.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "synth/gaussian_field.h"
#include "synth/wrinkle.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Histogram, HasTheShareOfEveryBin) {
  Grid<float> values(8, 8, 0.5f);
  Mask mask(8, 8, 1);
  values(0, 0) = 2.5f;
  values(7, 7) = 9.0f;  // outside, but a pixel of the map
  mask(3, 3) = 0;
  const auto found = histogram(values, mask, 0.0, 4.0, 4);
  EXPECT_DOUBLE_EQ(found.density[0], 61.0 / 63.0);
  EXPECT_DOUBLE_EQ(found.density[1], 0.0);
  EXPECT_DOUBLE_EQ(found.density[2], 1.0 / 63.0);
  EXPECT_DOUBLE_EQ(found.middle(2), 2.5);
}

TEST(Histogram, OfAGaussianSurfaceIsGaussianWithinItsErrors) {
  const WrinkleComponent<> component{
      .amplitude_mm = 0.2, .long_mm = 0.4, .short_mm = 0.4, .angle_rad = 0.0};
  constexpr int seeds = 12;
  double squares = 0.0;
  int count = 0;
  for (Seed seed = 0; seed < seeds; ++seed) {
    const auto height = gaussian_field([&](double fx, double fy) { return psd(component, fx, fy); },
                                       {384, 384, 0.1, Unit::mm}, seed);
    const auto found = histogram(height, Mask(384, 384, 1), -0.4, 0.4, 16);
    for (std::size_t k = 0; k < found.density.size(); ++k) {
      const double z = found.middle(k) / 0.2;
      // The mean over a bin of a quarter sigma exceeds the middle by its curvature / 24.
      const double expected = std::exp(-0.5 * z * z) / (0.2 * std::sqrt(2.0 * pi)) *
                              (1.0 + (z * z - 1.0) * 0.0625 / 24.0);
      squares += std::pow((found.density[k] - expected) / found.sigma[k], 2);
      ++count;
    }
  }
  // 12 x 16 errors, four neighbours of which go together: 1 to sqrt(2 * 4 / 192) = 0.2, times 3; a
  // jackknife of 16 parts has heavy tails, 15 / 13 on average.
  EXPECT_NEAR(squares / count, 15.0 / 13.0, 0.6);
}

TEST(Steepness, OfAPlaneIsItsGradient) {
  Grid<float> height(20, 30);
  for (int row = 0; row < 20; ++row) {
    for (int col = 0; col < 30; ++col) height(row, col) = 0.2f * (0.3f * col - 0.4f * row);
  }
  const auto steep = steepness(height, Mask(20, 30, 1), 0.2);
  for (const float value : steep) EXPECT_NEAR(value, 0.5f, 1e-5f);
}

}  // namespace
}  // namespace hada
