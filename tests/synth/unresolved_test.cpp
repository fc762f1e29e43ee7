#include "synth/unresolved.h"

#include <cmath>

#include <gtest/gtest.h>

#include "synth/synthesize.h"

namespace hada {
namespace {

const Wrinkle<> sheet{.components = {{0.05, 0.5, 0.2, 0.4}, {0.1, 2.0, 1.0, 1.9}}};

SlopeCovariance slopes_of(const Grid<float>& height, int step, double pitch) {
  SlopeCovariance sum;
  const int n = height.rows();
  const auto at = [&](int row, int col) { return double(height((row + n) % n, (col + n) % n)); };
  for (int row = 0; row < n; ++row) {
    for (int col = 0; col < n; ++col) {
      const double x = (at(row, col + step) - at(row, col - step)) / (2.0 * step * pitch);
      const double y = (at(row - step, col) - at(row + step, col)) / (2.0 * step * pitch);
      sum.xx += x * x / (n * n);
      sum.xy += x * y / (n * n);
      sum.yy += y * y / (n * n);
    }
  }
  return sum;
}

TEST(Unresolved, IsWhatACoarserMapLeavesOut) {
  // One sheet, its slopes over 2 x 0.02 mm and over 2 x 0.24 mm.
  const auto height = synthesize(sheet, {.rows = 1024, .cols = 1024, .pitch = 0.02}, 5).height;
  const auto fine = slopes_of(height, 1, 0.02), coarse = slopes_of(height, 12, 0.02);
  const auto left = unresolved_slopes(sheet, 0.24), tiny = unresolved_slopes(sheet, 0.02);
  // 20 x 20 mm hold some 1000 waves of 0.4 mm: a variance is known to about 4 %; three times that.
  const double tolerance = 0.12 * (left.xx + left.yy);
  EXPECT_NEAR(fine.xx - coarse.xx, left.xx - tiny.xx, tolerance);
  EXPECT_NEAR(fine.yy - coarse.yy, left.yy - tiny.yy, tolerance);
  EXPECT_NEAR(fine.xy - coarse.xy, left.xy - tiny.xy, tolerance);
  EXPECT_GT(std::abs(left.xy), tolerance);  // the sheet has a direction, and the sign is told
}

TEST(Unresolved, KnowsWhatComesBack) {
  Wrinkle<> ribs;
  ribs.components = {{0.02, 0.5, 0.2, 0.4}};
  ribs.repeated = {{.amplitude_mm = 0.1,
                    .long_mm = 0.4,
                    .short_mm = 0.25,
                    .angle_rad = 0.3,
                    .period_mm = 0.5,
                    .period_angle_rad = 1.0,
                    .repeats = 1.2}};
  ribs.woven = {{.amplitude_mm = 0.05,
                 .long_mm = 0.3,
                 .short_mm = 0.2,
                 .period_mm = 0.7,
                 .repeats = 1.5,
                 .other_period_mm = 0.6,
                 .other_period_angle_rad = 1.2}};
  const auto height = synthesize(ribs, {.rows = 1024, .cols = 1024, .pitch = 0.02}, 5).height;
  const auto fine = slopes_of(height, 1, 0.02), coarse = slopes_of(height, 12, 0.02);
  const auto left = unresolved_slopes(ribs, 0.24), tiny = unresolved_slopes(ribs, 0.02);
  const double tolerance = 0.12 * (left.xx + left.yy);  // as above
  EXPECT_NEAR(fine.xx - coarse.xx, left.xx - tiny.xx, tolerance);
  EXPECT_NEAR(fine.yy - coarse.yy, left.yy - tiny.yy, tolerance);
  EXPECT_NEAR(fine.xy - coarse.xy, left.xy - tiny.xy, tolerance);
}

TEST(Unresolved, IsNothingForAFineMapAndAllForACoarseOne) {
  const auto fine = unresolved_slopes(sheet, 1e-4), coarse = unresolved_slopes(sheet, 1e3);
  const auto all = slopes_of(synthesize(sheet, {1024, 1024, 0.02, Unit::mm}, 5).height, 1, 0.02);
  EXPECT_LT(fine.xx, 1e-5 * all.xx);
  EXPECT_NEAR(coarse.xx, all.xx, 0.12 * all.xx);
  EXPECT_NEAR(coarse.xy, all.xy, 0.12 * all.xx);
  EXPECT_EQ(roughness_of({}), 0.0);
  EXPECT_DOUBLE_EQ(roughness_of({0.005, 0.0, 0.005}), std::sqrt(0.1));
  EXPECT_EQ(roughness_of({5.0, 0.0, 5.0}), 1.0);
}

}  // namespace
}  // namespace hada
