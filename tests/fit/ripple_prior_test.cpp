#include "fit/ripple_prior.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

const Ripples::Box box{{-10.0, -10.0, -20.0}, {20.0, 20.0, 40.0}};

TEST(RipplePrior, MakesWavesThatAddUpToItsHeight) {
  const Ripples ripples = ripples_in(box, 600);
  const RipplePrior prior{.height = 0.3, .across = 6.0, .along = 12.0};
  const auto sigma = wave_sigma(ripples, prior);
  // At the walls free waves swing twice as high in variance; in the middle of the box they are
  // those of the process but for what its reflections hold, 2 exp(-pi^2 6^2 4 / (2 20^2)) and less
  // of it, and for the constant wave, which is not among the waves.
  double variance = 0.0;
  ripples.each({0.0, 0.0, 0.0}, [&](std::size_t n, double value, const auto&) {
    variance += sigma[n] * sigma[n] * value * value;
  });
  const double constant =
      0.09 * std::pow(2.0 * M_PI, 1.5) * 6.0 * 6.0 * 12.0 / (20.0 * 20.0 * 40.0);
  EXPECT_NEAR(variance + constant, 0.09, 0.04 * 0.09);
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
