#include "fit/ripple_prior.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

const Ripples::Box box{{-10.0, -10.0, -20.0}, {20.0, 20.0, 40.0}};

TEST(RipplePrior, MakesWavesThatAddUpToItsHeight) {
  const Ripples ripples = ripples_in(box, 3000);
  const RipplePrior prior{.height = 0.3, .across = 3.0, .along = 6.0};
  const auto sigma = wave_sigma(ripples, prior);
  // In the middle of the box waves are those of the process but for what its reflections hold,
  // (1 + sqrt(3) 20 / 3) exp(-sqrt(3) 20 / 3) = 1e-4 each, for the constant wave, which is not
  // among the waves, and for those shorter than the last: its wave number is 6.7 / across, and of
  // the spectrum 1.7 (sqrt(3) / 6.7)^3 = 3 % lie beyond.
  double variance = 0.0;
  ripples.each({0.0, 0.0, 0.0}, [&](std::size_t n, double value, const auto&) {
    variance += sigma[n] * sigma[n] * value * value;
  });
  const double constant =
      0.09 * 64.0 * M_PI / 2.0 / std::sqrt(27.0) * 3.0 * 3.0 * 6.0 / (20.0 * 20.0 * 40.0);
  EXPECT_NEAR(variance + constant, 0.985 * 0.09, 0.02 * 0.09);
}

TEST(RipplePrior, OrdersItsWavesFromLongToShort) {
  const Ripples ripples = ripples_in(box, 50);
  ASSERT_EQ(ripples.orders().size(), 50u);
  EXPECT_EQ(ripples.orders()[0], (Ripples::Orders{0, 0, 1}));  // along the longest side
  const auto sigma = wave_sigma(ripples, {.height = 0.3, .across = 6.0, .along = 12.0});
  EXPECT_GT(sigma.front(), sigma.back());
}

}  // namespace
}  // namespace hada
