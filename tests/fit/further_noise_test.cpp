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
  }
}

TEST(FurtherNoise, BoundsWhatAMapCannotShow) {
  const auto bounds = seen_bounds_of(RepeatedNoise<>{}, {100, 200, 0.5, Unit::mm});
  ASSERT_EQ(bounds.size(), RepeatedNoise<>::fields().size());
  EXPECT_DOUBLE_EQ(std::exp(bounds[1].low), 0.05);
  EXPECT_DOUBLE_EQ(std::exp(bounds[4].low), 1.0);
  EXPECT_DOUBLE_EQ(std::exp(bounds[4].high), 25.0);
  EXPECT_EQ(bounds[0].low, solver_bounds(RepeatedNoise<>::fields()[0]).low);
}

}  // namespace
}  // namespace hada
