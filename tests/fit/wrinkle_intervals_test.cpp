#include "fit/wrinkle_intervals.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"
#include "fit/wrinkle.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

/// A cut from a larger field, with noise.
Surface sheet(const WrinkleComponent<>& component, Seed seed, double noise, int size = 96) {
  const Wrinkle<> wrinkle{.components = {component}};
  const auto field = synthesize(wrinkle, {3 * size, 3 * size, 0.2, Unit::mm}, seed).height;
  Surface surface;
  surface.extent = {size, size, 0.2, Unit::mm};
  surface.mask = full_mask(surface.extent);
  surface.height = crop(field, size, size, size, size);
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col)
      surface.height(row, col) += float(noise * gaussian(seed + 900, row, col));
  }
  return surface;
}

TEST(WrinkleIntervals, HoldTheTruthOfRoundComponents) {
  std::map<std::string, int> held, asked;
  int told_by_sigma = 0;
  for (Seed seed = 0; seed < 16; ++seed) {
    const auto fit = fit_wrinkle(sheet({0.4, 0.8, 0.8, 0.7}, 500 + seed, 0.02), {.components = 1});
    const double angle = fit.material.components[0].angle_rad;
    for (const auto& [path, low, high] : fit.intervals) {
      ++asked[path];
      if (path.ends_with("angle_rad")) {
        const double middle = 0.5 * (low + high);
        held[path] += std::abs(std::remainder(0.7 - middle, pi)) <= 0.5 * (high - low) + 1e-9;
        told_by_sigma +=
            std::abs(std::remainder(0.7 - angle, pi)) <= 1.96 * fit.sigma.components[0].angle_rad;
      } else {
        held[path] += low <= 0.8 && 0.8 <= high;
      }
    }
  }
  ASSERT_EQ(asked.size(), 3u);  // both axes and the angle
  for (const auto& [path, count] : asked) {
    EXPECT_GE(count, 13) << path;
    // 95 % less three deviations of a binomial of 16.
    EXPECT_GE(held[path], 0.95 * count - 2.7) << path << " of " << count;
  }
  // A round component has no angle, and a sigma that says otherwise.
  EXPECT_LT(told_by_sigma, 12);
}

TEST(WrinkleIntervals, TellHowFarDownAFloorMayLie) {
  const auto fit = fit_wrinkle(sheet({0.4, 0.8, 0.4, 0.7}, 4, 0.0), {.components = 1});
  ASSERT_EQ(fit.intervals.size(), 1u);
  EXPECT_EQ(fit.intervals[0].path, "floor_mm4");
  EXPECT_EQ(fit.intervals[0].low, 0.0);  // the sheet has none
  EXPECT_GT(fit.intervals[0].high, fit.material.floor_mm4);
  // What side lobes leave at the highest frequencies lies more than five decades down.
  EXPECT_LT(fit.intervals[0].high, 1e-5 * psd(fit.material, 0.0, 0.0));
}

TEST(WrinkleIntervals, AreNotAskedForFarFromBounds) {
  const auto fit = fit_wrinkle(sheet({0.4, 0.8, 0.4, 0.7}, 3, 0.02), {.components = 1});
  EXPECT_TRUE(fit.intervals.empty());
}

TEST(WrinkleIntervals, ReachToTheBoundWhereTheMapIsSmall) {
  // 19 mm of wrinkles 5 mm long: on this one longer ones would look much alike, up to the bound.
  const auto fit = fit_wrinkle(sheet({0.4, 5.0, 2.5, 0.7}, 8, 0.02), {.components = 1});
  const auto interval = std::find_if(fit.intervals.begin(), fit.intervals.end(),
                                     [](const auto& i) { return i.path.ends_with("long_mm"); });
  ASSERT_NE(interval, fit.intervals.end());
  EXPECT_GT(interval->low, 1.0);
  EXPECT_LT(interval->low, 5.0);
  EXPECT_GT(interval->high, 100.0);
}

}  // namespace
}  // namespace hada
