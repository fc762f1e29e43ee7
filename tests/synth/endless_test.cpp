#include "synth/endless.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/fft.h"
#include "core/parallel.h"

namespace hada {
namespace {

Wrinkle<> sheet() {
  Wrinkle<> wrinkle;
  wrinkle.components = {{.amplitude_mm = 0.2, .long_mm = 1.2, .short_mm = 0.5, .angle_rad = 0.5},
                        {.amplitude_mm = 0.05, .long_mm = 0.3, .short_mm = 0.15, .angle_rad = 2.0}};
  return wrinkle;
}

constexpr Extent window{.rows = 96, .cols = 128, .pitch = 0.1, .unit = Unit::mm};

TEST(EndlessField, MeetsItsNeighbourWithoutASeam) {
  Wrinkle<> wrinkle = sheet();
  wrinkle.floor_mm4 = 1e-5;
  const auto here = endless_field(wrinkle, window, {0.0, 0.0}, 3);
  const auto right = endless_field(wrinkle, window, {6.4, -1.6}, 3);  // 64 columns, 16 rows
  for (int row = 16; row < 96; ++row) {
    for (int col = 64; col < 128; ++col)
      ASSERT_NEAR(here(row, col), right(row - 16, col - 64), 1e-5) << row << " " << col;
  }
}

TEST(EndlessField, IsTheSameSheetAtAnotherPitch) {
  const auto coarse = endless_field(sheet(), window, {3.0, 4.0}, 5);
  const Extent finer{288, 384, 0.1 / 3.0, Unit::mm};
  const auto fine = endless_field(sheet(), finer, {3.0, 4.0}, 5);
  for (int row = 0; row < 96; ++row) {
    for (int col = 0; col < 128; ++col)
      ASSERT_NEAR(coarse(row, col), fine(3 * row + 1, 3 * col + 1), 1e-5);
  }
}

TEST(EndlessField, HasTheSpectrumOfItsMaterial) {
  // The mean square of what is left when a wave has been taken out of many windows. A window of n
  // pixels sees the power of a band; far windows are independent.
  const Wrinkle<> wrinkle = sheet();
  constexpr int seeds = 60;
  const Extent square{64, 64, 0.25, Unit::mm};
  Grid<double> power(64, 33);
  Grid<double> taper(64, 64);
  double sum_w2 = 0.0;
  for (int row = 0; row < 64; ++row) {
    for (int col = 0; col < 64; ++col) {
      const double x = std::sin(3.14159265 * (row + 0.5) / 64);
      const double y = std::sin(3.14159265 * (col + 0.5) / 64);
      taper(row, col) = x * x * y * y;
      sum_w2 += taper(row, col) * taper(row, col);
    }
  }
  for (int k = 0; k < seeds; ++k) {
    auto field = endless_field(wrinkle, square, {1000.0 * k, -700.0 * k}, 9);
    Grid<double> tapered(64, 64);
    for (std::size_t i = 0; i < field.size(); ++i) tapered[i] = field[i] * taper[i];
    const auto half = fft(tapered);
    for (std::size_t i = 0; i < half.size(); ++i)
      power[i] += std::norm(half[i]) * 0.25 * 0.25 / sum_w2 / seeds;
  }
  // In bands of 8 x 8 ordinates a mean over 60 windows has 60 x 64 / 2.8 independent values (a Hann
  // window ties neighbours): 2.7 %, and the band is wide beside no slope of the spectrum: four of
  // those, and 2 % for the window's own width.
  for (int top = 0; top < 16; top += 8) {
    for (int left = 1; left < 17; left += 8) {
      double measured = 0.0, expected = 0.0;
      for (int row = top; row < top + 8; ++row) {
        for (int col = left; col < left + 8; ++col) {
          measured += power(row, col);
          expected += psd(wrinkle, col / 16.0, -row / 16.0);
        }
      }
      EXPECT_NEAR(measured / expected, 1.0, 0.13) << top << " " << left;
    }
  }
}

TEST(EndlessField, KnowsKernelsFarFinerThanAPixel) {
  Wrinkle<> wrinkle;
  wrinkle.components = {{.amplitude_mm = 0.1, .long_mm = 2e-3, .short_mm = 1e-3, .angle_rad = 0.0}};
  const auto field = endless_field(wrinkle, window, {0.0, 0.0}, 1);
  double squares = 0.0;
  for (const float value : field) squares += double(value) * value / double(field.size());
  // 12288 independent heights: their variance is known to sqrt(2 / 12288) = 1.3 %; four of those.
  EXPECT_NEAR(squares / 0.01, 1.0, 0.052);
}

TEST(EndlessField, IsTheSameAtAnyThreadCount) {
  set_threads(1);
  const auto one = endless_field(sheet(), window, {7.0, 0.0}, 2);
  set_threads(2);
  const auto two = endless_field(sheet(), window, {7.0, 0.0}, 2);
  set_threads(0);
  EXPECT_TRUE(std::equal(one.begin(), one.end(), two.begin()));
}

TEST(EndlessField, RefusesWhatWouldTakeHours) {
  Wrinkle<> threads;
  threads.repeated = {{0.2, 1e-3, 1e-3, 0.0, 1.0, 0.0, 30.0}};  // finer than a pixel
  const Extent large{12000, 12000, 0.1, Unit::mm};
  EXPECT_THROW(endless_field(threads, large, {0.0, 0.0}, 1), Error);
}

TEST(EndlessField, ComesBackAfterAPeriod) {
  Wrinkle<> threads;
  threads.components.clear();
  threads.repeated = {{.amplitude_mm = 0.2,
                       .long_mm = 0.25,
                       .short_mm = 0.15,
                       .angle_rad = 0.5,
                       .period_mm = 2.0,
                       .period_angle_rad = 0.0,
                       .repeats = 1.0}};
  double variance = 0.0, once = 0.0, twice = 0.0;
  int count = 0;
  for (int k = 0; k < 40; ++k) {
    const auto field = endless_field(threads, window, {50.0 * k, -30.0 * k}, 5);
    for (int row = 0; row < window.rows; ++row) {
      for (int col = 0; col + 40 < window.cols; ++col, ++count) {
        variance += field(row, col) * field(row, col);
        once += field(row, col) * field(row, col + 20);
        twice += field(row, col) * field(row, col + 40);
      }
    }
  }
  // 40 windows of 9.6 x 8.8 mm hold 40 x 85 / (4 pi 0.25 x 0.15) / 2.5 = 2900 independent
  // patches: a correlation is known to 2 %; three times that.
  EXPECT_NEAR(variance / count / 0.04, 1.0, 0.08);
  EXPECT_NEAR(once / variance, std::exp(-0.5), 0.06);
  EXPECT_NEAR(twice / variance, std::exp(-2.0), 0.06);
}

}  // namespace
}  // namespace hada
