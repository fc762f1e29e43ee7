#include "fit/ripple_prior.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

const Ripples::Box box{{-10.0, -10.0, -20.0}, {20.0, 20.0, 40.0}};

TEST(RipplePrior, MakesWavesThatAddUpToItsHeight) {
  const Ripples ripples = ripples_in(box, 600);
  const RipplePrior prior{.height = 0.3, .across = 6.0, .along = 12.0};
  const auto sigma = wave_sigma(ripples, prior);
  // In the middle of the box, over places whose cosines are all met: the mean variance is that of
  // the process less what the constant wave holds, which is not among the waves.
  double variance = 0.0;
  for (std::size_t n = 0; n < sigma.size(); ++n) {
    double waves = 1.0;
    for (const int order : ripples.orders()[n]) waves *= order > 0 ? 0.5 : 1.0;
    variance += sigma[n] * sigma[n] * waves;
  }
  const double constant =
      0.09 * std::pow(2.0 * M_PI, 1.5) * 6.0 * 6.0 * 12.0 / (20.0 * 20.0 * 40.0);
  // The process is no longer than a third of the box, whose border changes it by some per cent.
  EXPECT_NEAR(variance + constant, 0.09, 0.05 * 0.09);
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
