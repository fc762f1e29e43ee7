#include "synth/repeated_noise.h"

#include <cmath>
#include <numbers>

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include "windowed.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

RepeatedNoise<> ribs(double repeats) {
  return {.amplitude_mm = 0.3,
          .long_mm = 0.5,
          .short_mm = 0.2,
          .angle_rad = 0.7,
          .period_mm = 1.1,
          .period_angle_rad = 0.2,
          .repeats = repeats};
}

TEST(RepeatedNoise, HoldsTheVarianceItIsGiven) {
  for (const double repeats : {0.4, 0.6, 1.0, 3.0, 20.0}) {
    constexpr double step = 0.01;  // the narrowest lines, at 20 repeats, are 0.007 / 1.1 wide
    double sum = 0.0;
    for (double fx = -4.0; fx < 4.0; fx += step) {
      for (double fy = -4.0; fy < 4.0; fy += step) sum += psd(ribs(repeats), fx, fy) * step * step;
    }
    // Sums over equal steps of Gaussians at least 0.6 steps wide are exact to exp(-2 pi^2 0.36).
    EXPECT_NEAR(sum, 0.09, 2e-3 * 0.09) << repeats;
    EXPECT_NEAR(value_at(autocovariance(ribs(repeats)), 0.0, 0.0), 0.09, 1e-12) << repeats;
  }
}

TEST(RepeatedNoise, HasASpectrumThatIsTheTransformOfItsAutocovariance) {
  const auto covariance = autocovariance(ribs(1.5));
  constexpr double step = 0.05, reach = 14.0;  // 8 periods of 1.5 repeats and the kernel
  for (const auto& [fx, fy] : {std::pair{0.0, 0.0}, {0.9, 0.2}, {0.45, 0.1}, {1.8, 0.3}}) {
    double sum = 0.0;
    for (double dx = -reach; dx <= reach; dx += step) {
      for (double dy = -reach; dy <= reach; dy += step) {
        sum +=
            value_at(covariance, dx, dy) * std::cos(2.0 * pi * (fx * dx + fy * dy)) * step * step;
      }
    }
    // Sums over steps of 0.05 mm of Gaussians 0.14 mm wide are exact to exp(-2 pi^2 2.8^2 / 2).
    EXPECT_NEAR(sum, psd(ribs(1.5), fx, fy), 1e-9) << fx << " " << fy;
  }
}

TEST(RepeatedNoise, IsMultipliedByItsWindow) {
  auto overlapping = ribs(2.0);  // a kernel longer than its period
  overlapping.period_mm = 0.4;
  expect_multiplied_by_window(autocovariance(overlapping));
}

TEST(RepeatedNoise, IsFainterFromPeriodToPeriod) {
  // A kernel much shorter than its period: nothing else is felt at a multiple.
  RepeatedNoise<> threads = ribs(2.0);
  threads.long_mm = threads.short_mm = 0.05;
  const auto covariance = autocovariance(threads);
  for (const int n : {1, 2, 3}) {
    EXPECT_NEAR(value_at(covariance, n * covariance.x, n * covariance.y) / 0.09,
                std::exp(-n * n / 8.0), 1e-9);
  }
}

TEST(RepeatedNoise, IsPlainWhereNothingComesBack) {
  const auto noise = ribs(0.4);
  const auto plain = kernel_of(noise);
  // Lines 0.4 of their distance wide rise by 2 exp(-1 / (2 0.4^2)) = 8.8 %.
  for (const double fx : {0.1, 0.5, 1.0})
    EXPECT_NEAR(psd(noise, fx, 0.3) / psd(plain, fx, 0.3), 1.0, 0.1);
}

TEST(RepeatedNoise, SumsGaussiansOnBothSidesOfJacobisIdentity) {
  for (const double c : {0.01, 0.5, 3.1, 3.2, 20.0}) {
    double sum = 1.0;
    for (int n = 1; n < 200; ++n) sum += 2.0 * std::exp(-c * n * n);
    EXPECT_NEAR(sum_of_gaussians(c) / sum, 1.0, 1e-14) << c;
  }
}

TEST(RepeatedNoise, HasACombThatIsOneInTheMeanAndItsDerivatives) {
  for (const double width : {0.05, 0.3, 0.499, 0.501, 0.8}) {
    double sum = 0.0;
    for (int k = 0; k < 1000; ++k) sum += comb(-1.0 + k / 250.0, width) / 1000.0;
    EXPECT_NEAR(sum, 1.0, 1e-6) << width;
    using Jet = ceres::Jet<double, 2>;
    const Jet at = comb(Jet(1.37, 0), Jet(width, 1));
    constexpr double h = 1e-6;
    EXPECT_NEAR(at.v[0], (comb(1.37 + h, width) - comb(1.37 - h, width)) / (2 * h), 1e-6) << width;
    if (std::abs(width - 0.5) < h) continue;
    EXPECT_NEAR(at.v[1], (comb(1.37, width + h) - comb(1.37, width - h)) / (2 * h), 1e-6) << width;
  }
  for (const double phase : {0.0, 0.3, 0.5})  // where one form takes over from the other
    EXPECT_NEAR(comb(phase, 0.4999999), comb(phase, 0.5000001), 1e-6);
}

}  // namespace
}  // namespace hada
