#include "fit/wrinkle_refine.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "fit/wrinkle.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

Fit<Wrinkle<>> with_amplitudes(double first_sigma, double second_sigma) {
  Fit<Wrinkle<>> fit;
  fit.material.components = {{0.4, 1.6, 0.8, 0.5}, {0.1, 0.5, 0.3, 2.0}};
  fit.sigma.components = {{first_sigma, 0.1, 0.1, 0.1}, {second_sigma, 0.1, 0.1, 0.1}};
  return fit;
}

TEST(WrinkleRefine, TellsComponentsWhoseAmplitudeIsAboveItsSigma) {
  EXPECT_TRUE(all_told(with_amplitudes(0.05, 0.09)));
  EXPECT_FALSE(all_told(with_amplitudes(0.05, 0.11)));
  EXPECT_FALSE(all_told(with_amplitudes(0.41, 0.01)));  // any of them, not the last alone
  EXPECT_FALSE(all_told(with_amplitudes(0.05, std::numeric_limits<double>::quiet_NaN())));
}

TEST(WrinkleRefine, TakesBackWhatTheSpectrumDoesNotTell) {
  // Two noise functions that are one: only the sum of their powers is known.
  const Wrinkle<> truth{.components = {{0.4, 1.6, 0.8, 0.5}}};
  const auto seen =
      observe(synthesize(truth, {.rows = 128, .cols = 128, .pitch = 0.2, .unit = Unit::mm}, 3));
  Fit<Wrinkle<>> one, two;  // of cost 0: nothing explains better, so that they stay where they are
  one.material = two.material = truth;
  two.material.components[0].amplitude_mm = 0.4 / std::sqrt(2.0);
  two.material.components.push_back(two.material.components[0]);
  auto refined = two;
  refine(refined, seen, SlowWaves(seen.spectrum, seen.levelling));
  ASSERT_FALSE(all_told(refined));
  EXPECT_EQ(refined_and_told(two, {one}, seen).material.components.size(), 1u);
  // Where there is nothing smaller to go back to, it stays.
  EXPECT_EQ(refined_and_told(two, {}, seen).material.components.size(), 2u);
  EXPECT_EQ(refined_and_told(one, {one}, seen).material.components.size(), 1u);
}

}  // namespace
}  // namespace hada
