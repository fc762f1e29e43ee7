#include "fit/sequence_search.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "synth/forged.h"

namespace hada {
namespace {

const std::string truth = "CRCCRC";

GrainSpectrum spectrum_of_steel() {
  auto block = crop(forged_block({.sequence = truth}, {1024, 2048}, 6), 300, 400, 384, 512);
  double sum = 0.0, squares = 0.0;
  for (const float g : block) {
    sum += g;
    squares += double(g) * g;
  }
  const auto n = double(block.size());
  const double deviation = std::sqrt(squares / n - sum * sum / (n * n));
  for (float& g : block) g = float((g - sum / n) / deviation);
  return grain_spectrum(block);
}

TEST(SequenceSearch, PutsTheTrueSequenceFirst) {
  const auto spectrum = spectrum_of_steel();
  const SequenceSearchOptions options{.fewest_folds = 5, .most_folds = 7};
  const auto found = likely_sequences(first_guesses(spectrum, options), spectrum, options);
  ASSERT_GE(found.size(), 2u);
  EXPECT_EQ(found.front().model.sequence, truth);
  for (std::size_t k = 1; k < found.size(); ++k) EXPECT_GE(found[k].loss(), found[0].loss());
}

}  // namespace
}  // namespace hada
