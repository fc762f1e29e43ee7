#include "fit/further_noise.h"

#include <cmath>

#include <gtest/gtest.h>

#include "cut_picture.h"

namespace hada {
namespace {

// Brightness of a rib knit: ribs that come back, and what does not.
Wrinkle<> ribs() {
  Wrinkle<> wrinkle;
  wrinkle.components = {{.amplitude_mm = 0.05, .long_mm = 0.6, .short_mm = 0.4, .angle_rad = 0.4}};
  wrinkle.repeated = {{.amplitude_mm = 0.1,
                       .long_mm = 0.4,
                       .short_mm = 0.08,
                       .angle_rad = 0.5,
                       .period_mm = 0.9,
                       .period_angle_rad = 1.2,
                       .repeats = 3.0}};
  wrinkle.floor_mm4 = 1e-7;
  return wrinkle;
}

Observation seen_of(const Wrinkle<>& wrinkle) {
  return observe(cut_picture(spectrum_of(wrinkle), 8));
}

TEST(FurtherNoise, FindsWhatComesBack) {
  auto before = ribs();
  before.repeated.clear();
  const auto found = with_further_noise(before, seen_of(ribs()), 1);
  ASSERT_FALSE(found.empty());
  ASSERT_EQ(found.front().repeated.size(), 1u);
  const auto& noise = found.front().repeated.front();
  // A search in a hurry, good to go on from: lines 1 / (2 pi 3) of their distance wide are told
  // apart where a period is known to that share, 0.05 mm along it, and 0.05 rad across.
  EXPECT_NEAR(noise.period_mm, 0.9, 0.05);
  EXPECT_NEAR(noise.period_angle_rad, 1.2, 0.1);
  EXPECT_GT(noise.repeats, 1.0);
}

TEST(FurtherNoise, BeginsWithWhatDoesNotComeBack) {
  Wrinkle<> nothing;
  nothing.components.clear();
  nothing.floor_mm4 = 1e-6;
  for (const auto& found : with_further_noise(nothing, seen_of(ribs()), 1)) {
    EXPECT_EQ(found.components.size(), 1u);
    EXPECT_TRUE(found.repeated.empty());
    EXPECT_TRUE(found.woven.empty());
  }
}

TEST(FurtherNoise, FindsWhatComesBackTwoWays) {
  auto cloth = ribs();
  cloth.repeated.clear();
  const auto before = cloth;
  cloth.woven = {{.amplitude_mm = 0.1,
                  .long_mm = 0.15,
                  .short_mm = 0.1,
                  .angle_rad = 0.5,
                  .period_mm = 0.9,
                  .period_angle_rad = 1.2,
                  .repeats = 3.0,
                  .other_period_mm = 0.7,
                  .other_period_angle_rad = 2.5,
                  .other_repeats = 2.0}};
  const auto found = with_further_noise(before, seen_of(cloth), 1);
  ASSERT_FALSE(found.empty());
  ASSERT_EQ(found.front().woven.size(), 1u);
  // Any two steps of a lattice make it: what is told is the area between them, to some percent.
  const auto covariance = autocovariance(found.front().woven.front());
  const auto &p = covariance.p, &q = covariance.q;
  EXPECT_NEAR(std::abs(p.x * q.y - p.y * q.x), 0.9 * 0.7 * std::sin(1.3), 0.06);
}

TEST(FurtherNoise, WeighsEveryPeriod) {
  auto wrinkle = ribs();
  EXPECT_DOUBLE_EQ(weighed(100.0, wrinkle), 101.0);
  wrinkle.woven.resize(1);
  EXPECT_EQ(periods(wrinkle), 3);
}

TEST(FurtherNoise, BoundsWhatAMapCannotShow) {
  const auto bounds = seen_bounds_of(RepeatedNoise<>{}, {100, 200, 0.5, Unit::mm});
  ASSERT_EQ(bounds.size(), RepeatedNoise<>::fields().size());
  EXPECT_DOUBLE_EQ(std::exp(bounds[1].low), 0.05);
  EXPECT_DOUBLE_EQ(std::exp(bounds[1].high), 100.0);
  EXPECT_DOUBLE_EQ(std::exp(bounds[4].low), 1.0);
  EXPECT_DOUBLE_EQ(std::exp(bounds[4].high), 25.0);
  EXPECT_EQ(bounds[0].low, solver_bounds(RepeatedNoise<>::fields()[0]).low);
}

}  // namespace
}  // namespace hada
