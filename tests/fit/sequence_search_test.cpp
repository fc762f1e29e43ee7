#include "fit/sequence_search.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"
#include "synth/forged.h"

namespace hada {
namespace {

const std::string truth = "CRCCRC";

GrainSpectrum spectrum_of_steel() {
  auto block = crop(forged_block({.sequence = truth}, {1024, 2048}, 6), 300, 400, 256, 384);
  double sum = 0.0, squares = 0.0;
  for (const float g : block) {
    sum += g;
    squares += double(g) * g;
  }
  const auto n = double(block.size());
  const double deviation = std::sqrt(squares / n - sum * sum / (n * n));
  // Below a noise of 1 % no spectrum is believed; the fit adds it as well.
  for (int row = 0; row < block.rows(); ++row) {
    for (int col = 0; col < block.cols(); ++col)
      block(row, col) =
          float((block(row, col) - sum / n) / deviation + 0.01 * gaussian(8, row, col));
  }
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
