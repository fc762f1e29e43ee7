#include "fit/ring_rise.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

constexpr int sectors = 60, rings = 16;
constexpr double dark = 0.2, light = 0.5, first_radius = 40.0;

struct Stem {
  Unrolled flat;
  std::vector<double> radii;  // to the middle of the rise
  std::vector<RingChain> chains;
};

/// Rings 20 to 65 px wide that darken in their last third; each rises evenly over twice `share` of
/// it, seen through a pixel, with noise of 1 %.
Stem stem(double share, Seed seed) {
  Stem made;
  std::vector<double> starts = {first_radius};
  for (int k = 0; k < rings; ++k) starts.push_back(starts.back() + 20.0 + 45.0 * uniform(seed, k));
  const auto brightness = [&](double rho) {
    const auto next = std::upper_bound(starts.begin(), starts.end(), rho);
    if (next == starts.begin() || next == starts.end()) return dark;
    const double phase = (rho - *(next - 1)) / (*next - *(next - 1));
    const double risen = share > 0.0 ? std::min(0.5 * phase / share, 1.0) : 1.0;
    const double darkened = std::clamp((phase - 0.6) / 0.3, 0.0, 1.0);
    return dark + (light - dark) * risen * (1.0 - darkened);
  };
  made.flat.step = 0.5;
  made.flat.whole_turn = true;
  made.flat.sector_rad = 2.0 * M_PI / sectors;
  const int cols = int(2.0 * starts.back()) + 40;
  made.flat.values = Grid<float>(sectors, cols);
  for (int s = 0; s < sectors; ++s) {
    made.flat.theta.push_back((s + 0.5) * made.flat.sector_rad);
    for (int col = 0; col < cols; ++col) {
      constexpr int parts = 20;
      double seen = 0.0;
      for (int k = 0; k < parts; ++k)
        seen += brightness(made.flat.rho(col) + (k + 0.5) / parts - 0.5) / parts;
      made.flat.values(s, col) = float(std::log(seen * (1.0 + 0.01 * gaussian(seed + 1, s, col))));
    }
  }
  for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
    made.radii.push_back(starts[k] + share * (starts[k + 1] - starts[k]));
    RingChain chain;
    for (int s = 0; s < sectors; ++s) chain.push_back({s, made.radii.back(), 1.0});
    made.chains.push_back(std::move(chain));
  }
  return made;
}

TEST(RingRise, SaysHowFarBeforeItsMiddleARingBegins) {
  for (Seed seed = 1; seed <= 6; ++seed) {
    const auto made = stem(0.02, seed);
    const auto rise = ring_rise(made.chains, made.radii, made.flat);
    // An even rise begins sqrt(3) / 1.98 as far as one of unknown shape: 13 % nearer. What is cut
    // off its blurred ends, slopes under a tenth of the steepest, takes as much from its variance.
    EXPECT_NEAR(rise.share, 0.02, 0.004) << seed;
    EXPECT_NEAR(rise.share, 0.02, 2.5 * rise.sigma) << seed;
    const auto onset = onset_of(rise, made.radii);
    EXPECT_DOUBLE_EQ(onset.before[5], rise.share * (made.radii[6] - made.radii[5]));
  }
}

TEST(RingRise, IsNoneWhereBoundariesAreSharp) {
  for (Seed seed = 11; seed <= 16; ++seed) {
    const auto made = stem(0.0, seed);
    EXPECT_EQ(ring_rise(made.chains, made.radii, made.flat).share, 0.0) << seed;
  }
}

TEST(RingRise, IsNotToldByFewRings) {
  auto made = stem(0.02, 1);
  made.radii.resize(6);
  made.chains.resize(6);
  const auto rise = ring_rise(made.chains, made.radii, made.flat);
  EXPECT_EQ(rise.share, 0.0);
  for (const double before : onset_of(rise, made.radii).before) EXPECT_EQ(before, 0.0);
}

}  // namespace
}  // namespace hada
