#include "measure/spectral_hump.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

const SpectralHump waves{std::log(0.3), std::log(0.2), std::log(0.15), std::log(0.25), 0.7, false};
const SpectralHump ring{std::log(0.3), std::log(0.2), std::log(0.15), 0.0, 0.0, true};

double variance_of(const SpectralHump& hump) {
  constexpr double step = 0.004;
  double sum = 0.0;
  for (double fy = -0.6; fy < 0.6; fy += step) {
    for (double fx = -0.6; fx < 0.6; fx += step) sum += HumpDensity(hump)(fx, fy) * step * step;
  }
  return sum;
}

TEST(SpectralHump, HoldsItsVariance) {
  // A sum over so smooth a density is exact but for what lies beyond 0 on the other half plane: at
  // 1 / 0.15 widths, nothing.
  EXPECT_NEAR(variance_of(waves), 0.3, 1e-4);
  EXPECT_NEAR(variance_of(ring), 0.3, 1e-4);
}

TEST(SpectralHump, IsTheSameAtBothSidesOfZero) {
  EXPECT_DOUBLE_EQ(HumpDensity(waves)(0.11, 0.13), HumpDensity(waves)(-0.11, -0.13));
  EXPECT_GT(HumpDensity(waves)(0.2 * std::cos(0.7), 0.2 * std::sin(0.7)),
            HumpDensity(waves)(0.2, 0.0));
  EXPECT_DOUBLE_EQ(HumpDensity(ring)(0.2, 0.0), HumpDensity(ring)(0.0, -0.2));
}

TEST(SpectralHump, IsFaintBeyondItsReach) {
  for (const SpectralHump& hump : {waves, ring}) {
    const HumpDensity density(hump);
    const double top = HumpDensity(hump)(0.2 * std::cos(0.7), 0.2 * std::sin(0.7));
    double largest[2] = {0.0, 0.0};  // share of the top, on the border of the reach
    for (double f = -0.5; f < 0.5; f += 0.001) {
      largest[0] = std::max(largest[0], density(density.reach(0, 3.0), f) / top);
      largest[1] = std::max(largest[1], density(f, density.reach(1, 3.0)) / top);
    }
    for (const double share : largest) {
      EXPECT_LT(share, std::exp(-0.5 * 9.0) * 1.001);
      EXPECT_GT(share, std::exp(-0.5 * 25.0));  // and not far beyond
    }
  }
}

TEST(SpectralHump, HasTheDerivativesOfItsLogarithm) {
  for (const SpectralHump& hump : {waves, ring}) {
    SpectralHump::Parameters told;
    const double density = HumpDensity(hump)(0.14, 0.11, told);
    EXPECT_DOUBLE_EQ(density, HumpDensity(hump)(0.14, 0.11));
    for (std::size_t i = 0; i < told.size(); ++i) {
      constexpr double step = 1e-5;  // an error of step^2 times a third derivative of some hundreds
      auto higher = hump.parameters(), lower = higher;
      higher[i] += step;
      lower[i] -= step;
      const double slope = std::log(HumpDensity(hump.with(higher))(0.14, 0.11) /
                                    HumpDensity(hump.with(lower))(0.14, 0.11)) /
                           (2.0 * step);
      EXPECT_NEAR(told[i], slope, 1e-6) << i;
    }
  }
}

}  // namespace
}  // namespace hada
