#include "measure/leakage.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"
#include "core/surface.h"

namespace hada {
namespace {

TEST(Leakage, SharesOutTheWholePower) {
  const Extent extent{64, 80, 0.5, Unit::mm};
  Grid<float> map(64, 80);
  for (int i = 0; i < int(map.size()); ++i) map[std::size_t(i)] = float(gaussian(2, i));
  const auto spectrum = power_spectrum(map, full_mask(extent), extent);
  const auto leaked = leakage(spectrum);
  double power = 0.0, shared = 0.0, far = 0.0;
  for (std::size_t i = 0; i < spectrum.power.size(); ++i) {
    power += spectrum.power[i];
    shared += leaked.near[i] + leaked.far[i];
    far += leaked.far[i];
  }
  EXPECT_NEAR(shared / power, 1.0, 1e-9);  // the window sums to 1; rounding
  EXPECT_NEAR(far / shared, leaked.far_share, 1e-9);
  EXPECT_LT(leaked.far_share, 0.05);
}

TEST(Leakage, PredictsTheSideLobesOfAPureWave) {
  // A wave between two frequencies of the grid: away from its peak there is nothing but leakage.
  const Extent extent{128, 128, 1.0, Unit::px};
  Grid<float> map(128, 128);
  for (int row = 0; row < 128; ++row) {
    for (int col = 0; col < 128; ++col) {
      map(row, col) = float(std::cos(2.0 * std::numbers::pi * 10.5 / 128.0 * col));
    }
  }
  const auto spectrum = power_spectrum(map, full_mask(extent), extent);
  const auto leaked = leakage(spectrum);
  double measured = 0.0, predicted = 0.0;
  for (int col = 22; col < 32; ++col) {
    measured += spectrum.power(0, col);
    predicted += leaked.near(0, col) + leaked.far(0, col);
  }
  // The measured power that shines was itself spread by the window: what arrives is spread twice.
  EXPECT_GT(predicted, measured);
  EXPECT_LT(predicted, 4.0 * measured);
}

}  // namespace
}  // namespace hada
