#include "fit/grain_rotation.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fit/grain_turn.h"
#include "tests/fit/noisy.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Grain of variance 1 with a little noise, as a photograph has.
Grid<float> noisy_grain(const std::string& sequence, double angle_rad) {
  auto block = crop(forged_block({.sequence = sequence}, {1024, 2048}, 4), 200, 500, 320, 480);
  if (angle_rad != 0.0) block = turned_back(block, -angle_rad);
  return noisy(std::move(block), 0.1, 5);
}

GrainAngle found(const std::string& sequence, double angle_rad, double start_rad) {
  const auto scores = noisy_grain(sequence, angle_rad);
  const GrainNuisance nuisance{.variance = 1.0, .blur_px = 0.05, .floor = 0.01, .step = 0.01};
  const SequenceCandidate grain{grain_model(sequence, HammerKernel::both, grain_spectrum(scores)),
                                {nuisance}};
  return likeliest_angle(GrainRotation(scores), grain, start_rad);
}

TEST(GrainRotation, IsFoundWithinItsSigma) {
  for (const double truth : {-4.0 * degree, 0.0, 2.5 * degree}) {
    const auto angle = found("CCRC", truth, truth + 1.3 * degree);
    EXPECT_LT(angle.sigma_rad, 0.5 * degree);
    EXPECT_NEAR(angle.angle_rad, truth, 4.0 * angle.sigma_rad) << truth / degree;
    EXPECT_EQ(angle.gain > 10.0, truth != 0.0);
  }
}

TEST(GrainRotation, AtAngleZeroAgreesWithTheModelOfTheCells) {
  // What changes from one sequence to the next is the same, whether cells or ordinates are counted:
  // cells hold the mean, and give away a few nats of some thousand.
  const auto scores = noisy_grain("CRC", 0.0);
  const auto spectrum = grain_spectrum(scores);
  const GrainNuisance nuisance{.variance = 1.0, .blur_px = 0.05, .floor = 0.01, .step = 0.01};
  const GrainRotation rotation(scores);
  const auto right = grain_model("CRC", HammerKernel::both, spectrum);
  const auto wrong = grain_model("CCR", HammerKernel::both, spectrum);
  const double by_cells =
      grain_cost(wrong, nuisance, spectrum) - grain_cost(right, nuisance, spectrum);
  const double by_ordinates =
      rotation.log_likelihood(right, nuisance, 0.0) - rotation.log_likelihood(wrong, nuisance, 0.0);
  EXPECT_GT(by_cells, 100.0);
  EXPECT_NEAR(by_ordinates / by_cells, 1.0, 0.05);
}

TEST(GrainRotation, TakesAModelThatWasMadeForASmallerPicture) {
  const auto scores = noisy_grain("CRC", 0.0);
  const GrainNuisance nuisance{.variance = 1.0, .floor = 0.01, .step = 0.01};
  const GrainRotation rotation(scores);
  const auto of = [&](const Grid<float>& picture) {
    const auto model = grain_model("CRC", HammerKernel::both, grain_spectrum(picture));
    return rotation.log_likelihood(model, nuisance, degree);
  };
  // The slopes of the model, of which the error of quantising depends, are those of the sequence.
  EXPECT_NEAR(of(crop(scores, 10, 10, 120, 160)) / of(scores), 1.0, 1e-12);
}

}  // namespace
}  // namespace hada
