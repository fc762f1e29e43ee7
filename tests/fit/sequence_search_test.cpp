#include "fit/sequence_search.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"
#include "synth/forged.h"
#include "tests/fit/noisy.h"

namespace hada {
namespace {

const std::string truth = "CRCCRC";

GrainSpectrum spectrum_of_steel() {
  auto block = crop(forged_block({.sequence = truth}, {1024, 2048}, 6), 300, 400, 256, 384);
  // Below a noise of 1 % no spectrum is believed; the fit adds it as well.
  return grain_spectrum(noisy(std::move(block), 0.01, 8));
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
