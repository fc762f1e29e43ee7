#include "synth/wrinkle.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hada {
namespace {

const WrinkleComponent<> oriented{0.3, 2.5, 1.0, 0.7};

/// The integral of `density(fx, fy)` over |fx|, |fy| < 1.5 by the midpoint rule.
template <class Density>
double integral(const Density& density) {
  const double step = 0.01;
  double sum = 0.0;
  for (int i = -150; i < 150; ++i) {
    for (int j = -150; j < 150; ++j) sum += density((i + 0.5) * step, (j + 0.5) * step);
  }
  return sum * step * step;
}

TEST(Wrinkle, HasTheVarianceOfItsAmplitude) {
  // The midpoint rule is exact to rounding for a Gaussian this wide; its tails beyond the square
  // are e^-88.
  EXPECT_NEAR(integral([](double fx, double fy) { return psd(oriented, fx, fy); }), 0.09, 1e-9);
}

TEST(Wrinkle, KeepsItsVarianceUnderAWindow) {
  // The window multiplies the autocovariance by 1 at zero lag.
  EXPECT_NEAR(integral([](double fx, double fy) {
                return psd(oriented, fx, fy, {0.1, 0.0, 0.02});
              }),
              0.09, 1e-9);
}

TEST(Wrinkle, IsTheFourierTransformOfItsKernelSquared) {
  // |G^(f)|^2 with G = exp(-u^2 / (2 l^2) - v^2 / (2 s^2)) / sqrt(pi l s), summed directly.
  const double fx = 0.11, fy = -0.07, step = 0.1;
  double re = 0.0, im = 0.0;
  for (int i = -150; i <= 150; ++i) {
    for (int j = -150; j <= 150; ++j) {
      const double x = i * step, y = j * step;
      const double u = x * std::cos(0.7) + y * std::sin(0.7);
      const double v = -x * std::sin(0.7) + y * std::cos(0.7);
      const double g =
          std::exp(-u * u / (2 * 2.5 * 2.5) - v * v / 2) / std::sqrt(std::numbers::pi * 2.5 * 1.0);
      const double phase = 2.0 * std::numbers::pi * (fx * x + fy * y);
      re += g * std::cos(phase) * step * step;
      im += g * std::sin(phase) * step * step;
    }
  }
  // Sums of Gaussians over a grid ten times finer than them are exact to rounding.
  EXPECT_NEAR(psd(oriented, fx, fy), 0.09 * (re * re + im * im), 1e-9);
}

TEST(Wrinkle, AddsItsComponentsAndItsFloor) {
  const WrinkleComponent<> other{0.1, 1.0, 0.5, 2.0};
  const Wrinkle<> both{.components = {oriented, other}, .floor_mm4 = 0.01};
  EXPECT_DOUBLE_EQ(psd(both, 0.2, 0.1), 0.01 + psd(oriented, 0.2, 0.1) + psd(other, 0.2, 0.1));
}

TEST(Wrinkle, KeepsThePowerOfThinLinesOnATile) {
  for (const double repeats : {0.5, 3.0, 10.0, 30.0}) {
    for (const double side : {20.0, 20.5}) {  // whole periods, and not
      Wrinkle<> threads;
      threads.components.clear();
      threads.repeated = {{0.3, 0.4, 0.2, 0.5, 1.0, 0.0, repeats}};
      const Extent tile{205, 205, side / 205, Unit::mm};
      const auto spectrum = spectrum_of(threads, window_of_tile(threads, tile));
      double sum = 0.0;
      for (int i = -102; i <= 102; ++i) {
        for (int j = -102; j <= 102; ++j) sum += spectrum(j / side, i / side);
      }
      // Lines half a step wide ripple by 2 exp(-pi^2 / 2) = 1.4 % with where they lie.
      EXPECT_NEAR(sum / (side * side) / 0.09, 1.0, 0.015) << repeats << " " << side;
    }
  }
}

TEST(Wrinkle, KeepsThePowerOfStripesAsLongAsTheTile) {
  const Extent tile{100, 100, 0.2, Unit::mm};
  for (const double length : {2.0, 3.3, 3.4, 8.0, 100.0}) {
    const Wrinkle<> stripes{.components = {{0.3, length, 0.4, 0.0}}};
    const auto spectrum = spectrum_of(stripes, window_of_tile(stripes, tile));
    double sum = 0.0;
    for (int i = -50; i < 50; ++i) {
      for (int j = -50; j < 50; ++j) sum += spectrum(j / 20.0, i / 20.0);
    }
    // As above; without a window the longest would have 28 times their power.
    EXPECT_NEAR(sum / 400.0 / 0.09, 1.0, 0.015) << length;
  }
}

}  // namespace
}  // namespace hada
