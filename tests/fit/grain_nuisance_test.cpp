#include "fit/grain_nuisance.h"

#include <cmath>

#include <gtest/gtest.h>

#include "synth/forged.h"

namespace hada {
namespace {

TEST(GrainNuisance, OfTheTrueSequenceExplainsBest) {
  auto block = crop(forged_block({.sequence = "CRCRCR"}, {1024, 2048}, 9), 300, 400, 256, 512);
  double mean = 0.0, squares = 0.0;
  for (const float g : block) mean += g / double(block.size());
  for (float& g : block) {
    g -= float(mean);
    squares += double(g) * g / double(block.size());
  }
  for (float& g : block) g /= float(std::sqrt(squares));
  const auto spectrum = grain_spectrum(block);
  const auto cost = [&](const std::string& sequence) {
    auto model = grain_model(sequence, HammerKernel::both, spectrum);
    const auto fit = fit_nuisance(model, spectrum, {}, 60);
    // The descent never ends above its start, and says what it ended at.
    EXPECT_LE(fit.cost, grain_cost(model, {}, spectrum));
    EXPECT_NEAR(fit.cost, grain_cost(model, fit.nuisance, spectrum), 1e-6 * fit.cost);
    return fit.cost;
  };
  const double right = cost("CRCRCR");
  EXPECT_LT(right, cost("CCCRRR"));
  EXPECT_LT(right, cost("CRCRC"));
}

}  // namespace
}  // namespace hada
