#include "synth/woven_noise.h"

#include <cmath>
#include <numbers>

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include "synth/endless.h"
#include "synth/wrinkle.h"
#include "windowed.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

WovenNoise<> weave(double repeats, double other_repeats) {
  return {.amplitude_mm = 0.3,
          .long_mm = 0.5,
          .short_mm = 0.2,
          .angle_rad = 0.7,
          .period_mm = 1.1,
          .period_angle_rad = 0.2,
          .repeats = repeats,
          .other_period_mm = 0.8,
          .other_period_angle_rad = 1.5,
          .other_repeats = other_repeats};
}

TEST(WovenNoise, HoldsTheVarianceItIsGiven) {
  for (const auto& [repeats, other] : {std::pair{0.4, 0.4}, {1.0, 3.0}, {8.0, 0.6}}) {
    constexpr double step = 0.01;  // the narrowest lines, at 8 repeats, are 0.02 / 1.1 wide
    double sum = 0.0;
    for (double fx = -4.0; fx < 4.0; fx += step) {
      for (double fy = -4.0; fy < 4.0; fy += step)
        sum += psd(weave(repeats, other), fx, fy) * step * step;
    }
    // Sums over equal steps of Gaussians at least 1.8 steps wide are exact; e^-20 lies beyond 4.
    EXPECT_NEAR(sum, 0.09, 2e-3 * 0.09) << repeats;
    EXPECT_NEAR(value_at(autocovariance(weave(repeats, other)), 0.0, 0.0), 0.09, 1e-12) << repeats;
  }
}

TEST(WovenNoise, HasASpectrumThatIsTheTransformOfItsAutocovariance) {
  const auto covariance = autocovariance(weave(1.5, 0.9));
  constexpr double step = 0.05, reach = 14.0;  // 8 periods of 1.5 repeats and the kernel
  for (const auto& [fx, fy] : {std::pair{0.0, 0.0}, {0.9, 0.2}, {0.45, 1.1}}) {
    double sum = 0.0;
    for (double dx = -reach; dx <= reach; dx += step) {
      for (double dy = -reach; dy <= reach; dy += step) {
        sum +=
            value_at(covariance, dx, dy) * std::cos(2.0 * pi * (fx * dx + fy * dy)) * step * step;
      }
    }
    // Sums over steps of 0.05 mm of Gaussians 0.14 mm wide are exact to exp(-2 pi^2 2.8^2 / 2).
    EXPECT_NEAR(sum, psd(weave(1.5, 0.9), fx, fy), 1e-8) << fx << " " << fy;
  }
}

TEST(WovenNoise, IsMultipliedByItsWindow) {
  auto overlapping = weave(2.0, 1.0);  // a kernel longer than a period
  overlapping.period_mm = 0.4;
  expect_multiplied_by_window(autocovariance(overlapping));
}

TEST(WovenNoise, IsFeltAgainAtEveryCrossing) {
  auto threads = weave(2.0, 3.0);
  threads.long_mm = threads.short_mm = 0.04;  // nothing else is felt at a crossing
  const auto covariance = autocovariance(threads);
  const auto& [p, q] = std::pair{covariance.p, covariance.q};
  for (const auto& [n, m] : {std::pair{1, 0}, {0, 1}, {2, -1}, {-1, -2}}) {
    EXPECT_NEAR(value_at(covariance, n * p.x + m * q.x, n * p.y + m * q.y) / 0.09,
                std::exp(-n * n / 8.0 - m * m / 18.0), 1e-9);
  }
}

TEST(WovenNoise, ComesBackOneWayWhereTheOtherHasNoRepeats) {
  const auto woven = weave(3.0, 0.4);
  const RepeatedNoise<> ribs{woven.amplitude_mm, woven.long_mm,   woven.short_mm,
                             woven.angle_rad,    woven.period_mm, woven.period_angle_rad,
                             woven.repeats};
  // Lines 0.4 of their distance wide rise by 2 exp(-1 / (2 0.4^2)) = 8.8 %.
  for (const double fx : {0.1, 0.5, 0.9})
    EXPECT_NEAR(psd(woven, fx, 0.3) / psd(ribs, fx, 0.3), 1.0, 0.1);
}

TEST(WovenNoise, SumsOverCrossingsWithItsDerivatives) {
  for (const auto& [nn, nm, mm] : {std::array{0.3, 0.1, 0.2}, {4.0, -1.0, 0.5}, {0.02, 0.0, 9.0}}) {
    double sum = 0.0;
    for (int n = -80; n <= 80; ++n) {
      for (int m = -80; m <= 80; ++m)
        sum += std::exp(-(nn * n * n + 2.0 * nm * n * m + mm * m * m));
    }
    // `comb` leaves out Gaussians of 4e-9 of the sum where its lines flow together.
    EXPECT_NEAR(sum_over_crossings(nn, nm, mm) / sum, 1.0, 1e-7);
    using Jet = ceres::Jet<double, 3>;
    const Jet at = sum_over_crossings(Jet(nn, 0), Jet(nm, 1), Jet(mm, 2));
    constexpr double h = 1e-5;
    EXPECT_NEAR(at.v[1],
                (sum_over_crossings(nn, nm + h, mm) - sum_over_crossings(nn, nm - h, mm)) / (2 * h),
                1e-4 * sum);
  }
}

TEST(WovenNoise, ComesBackInAWindowOfAnEndlessSheet) {
  Wrinkle<> cloth;
  cloth.components.clear();
  cloth.woven = {{.amplitude_mm = 0.2,
                  .long_mm = 0.25,
                  .short_mm = 0.15,
                  .angle_rad = 0.5,
                  .period_mm = 2.0,
                  .period_angle_rad = 0.0,
                  .repeats = 1.0,
                  .other_period_mm = 1.5,
                  .other_period_angle_rad = 0.5 * pi,
                  .other_repeats = 1.5}};
  const Extent window{.rows = 88, .cols = 96, .pitch = 0.1, .unit = Unit::mm};
  double variance = 0.0, across = 0.0, up = 0.0;
  int count = 0;
  for (int k = 0; k < 40; ++k) {
    const auto field = endless_field(cloth, window, {50.0 * k, -30.0 * k}, 5);
    for (int row = 0; row + 15 < window.rows; ++row) {
      for (int col = 0; col + 20 < window.cols; ++col, ++count) {
        variance += field(row, col) * field(row, col);
        across += field(row, col) * field(row, col + 20);
        up += field(row, col) * field(row + 15, col);
      }
    }
  }
  // As for noise that comes back one way, of which a window holds 1.5 sqrt(2 pi) times as much: a
  // correlation is known to 4 %; twice that.
  EXPECT_NEAR(variance / count / 0.04, 1.0, 0.12);
  EXPECT_NEAR(across / variance, std::exp(-0.5), 0.08);
  EXPECT_NEAR(up / variance, std::exp(-1.0 / 4.5), 0.08);
}

}  // namespace
}  // namespace hada
