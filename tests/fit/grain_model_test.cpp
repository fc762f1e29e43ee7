#include "fit/grain_model.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

GrainSpectrum noise_spectrum() {
  Grid<float> noise(96, 128);
  for (int row = 0; row < 96; ++row) {
    for (int col = 0; col < 128; ++col) noise(row, col) = float(gaussian(8, row, col));
  }
  return grain_spectrum(noise);
}

TEST(GrainModel, HasTheCovarianceOfTheSteps) {
  // One cut: every place twice, then the mean of three: weights 1 2 2 1, that meet themselves with
  // 10 8 4 1. Across, the mean of three alone: 3 2 1.
  const auto model = grain_model("C", HammerKernel::both, noise_spectrum());
  const auto along = grain_covariance(model, 'C', 5), down = grain_covariance(model, 'R', 5);
  const std::vector<double> steps_along{1.0, 0.8, 0.4, 0.1, 0.0},
      steps_down{1, 2.0 / 3, 1.0 / 3, 0};
  for (std::size_t k = 0; k < steps_along.size(); ++k)
    EXPECT_NEAR(along[covariance_steps * k], steps_along[k], 1e-9);
  for (std::size_t k = 0; k < steps_down.size(); ++k)
    EXPECT_NEAR(down[covariance_steps * k], steps_down[k], 1e-9);
}

TEST(GrainModel, IsTheSameAfterAnotherScale) {
  const auto spectrum = noise_spectrum();
  const auto model = grain_model("CCR", HammerKernel::both, spectrum);
  auto other = grain_model("CCR", HammerKernel::both, spectrum, 1.2, 0.95);
  EXPECT_NE(other.along, model.along);
  EXPECT_LT(other.slope_y, model.slope_y);  // larger places are less steep
  rescale(other, spectrum, 1.0, 1.0);
  EXPECT_EQ(other.along, model.along);
  EXPECT_EQ(other.down, model.down);
  EXPECT_EQ(other.variance, model.variance);
}

TEST(GrainModel, TakesTheSlopesAtTheEdgesOfLevelsFromAnother) {
  const auto spectrum = noise_spectrum();
  const auto steep = grain_model("CR", HammerKernel::both, spectrum);
  const auto drawn = grain_model("CCCR", HammerKernel::both, spectrum);
  const GrainNuisance seen{.steeper_x = 0.9, .steeper_y = 1.2};
  const auto carried = carried_over(seen, steep, drawn);
  EXPECT_DOUBLE_EQ(carried.steeper_x * drawn.slope_x, seen.steeper_x * steep.slope_x);
  EXPECT_DOUBLE_EQ(carried.steeper_y * drawn.slope_y, seen.steeper_y * steep.slope_y);
  // Slopes that a sequence does not have by itself cost it something, also where levels are so fine
  // that nothing is seen of them.
  const GrainNuisance fine{.step = 1e-6, .steeper_x = carried.steeper_x};
  EXPECT_GT(grain_cost(drawn, fine, spectrum), grain_cost(drawn, {.step = 1e-6}, spectrum) + 1.0);
}

TEST(GrainModel, ExpectsTheVarianceOfNoiseAndLevels) {
  const auto spectrum = noise_spectrum();
  const auto model = grain_model("CR", HammerKernel::both, spectrum);
  const auto mean = [&](double floor, double step) {
    std::vector<double> expected;
    expected_cells(model, {.variance = 0.8, .blur_px = 0.02, .floor = floor, .step = step},
                   spectrum, expected);
    double sum = 0.0, count = 0.0;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      sum += spectrum.count[k] * expected[k];
      count += spectrum.count[k];
    }
    return sum / count;
  };
  const double grain = mean(0.0, 1e-4);
  EXPECT_NEAR(mean(0.1, 1e-4) - grain, 0.1, 1e-6);
  // The error of rounding is step^2 / 12; the series stops at a term of 1 / (28 + 5)^2, which
  // leaves out three per cent of it.
  EXPECT_NEAR(mean(0.0, 0.4) - grain, 0.4 * 0.4 / 12.0, 0.04 * 0.4 * 0.4 / 12.0);
}

}  // namespace
}  // namespace hada
