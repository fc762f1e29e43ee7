#include "measure/response.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(Response, LeavesLongWavesAlone) {
  EXPECT_EQ(photographed_amplitude(0.0, 0.0, 0.2), 1.0);
  EXPECT_NEAR(photographed_amplitude(0.01, -0.02, 0.2), 1.0, 2e-4);
}

TEST(Response, IsWhatPixelsAndTrapezoidsMakeOfAWave) {
  // z = sin(2 pi f x): the mean slope over a pixel is the difference across it, and the mean of two
  // such slopes is (z(x + 3h/2) - z(x - h/2)) / 2 from one pixel to the next.
  constexpr double pitch = 0.3;
  for (const double f : {0.2, 0.7, 1.4}) {
    const auto z = [&](double pixels) {
      return std::sin(2.0 * std::numbers::pi * f * pitch * pixels);
    };
    const double step = 0.5 * (z(1.5) - z(-0.5));
    EXPECT_NEAR(step / (z(1.0) - z(0.0)), photographed_amplitude(f, 0.0, pitch), 1e-12);
    EXPECT_NEAR(photographed_amplitude(0.0, f, pitch), photographed_amplitude(f, 0.0, pitch),
                1e-15);
  }
}

TEST(Response, FallsToNothingAtNyquist) {
  EXPECT_NEAR(photographed_amplitude(2.5, 0.0, 0.2), 0.0, 1e-12);
  EXPECT_NEAR(photographed_amplitude(2.5, 2.5, 0.2), 0.0, 1e-12);
}

TEST(Response, NoiseOfSlopesGrowsTowardsLongWaves) {
  // Far below Nyquist the height is the slope over 2 pi f: pitch^2 / (2 pi f)^2.
  constexpr double pitch = 0.2;
  const double f = 0.02;
  const double expected = pitch * pitch / std::pow(2.0 * std::numbers::pi * f, 2);
  // Relative terms of order (pi f pitch)^2 = 2e-4 are left out.
  EXPECT_NEAR(integrated_noise(f, 0.0, pitch) / expected, 1.0, 1e-3);
  EXPECT_NEAR(integrated_noise(0.6 * f, 0.8 * f, pitch) / expected, 1.0, 1e-3);
}

}  // namespace
}  // namespace hada
