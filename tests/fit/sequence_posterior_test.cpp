#include "fit/sequence_posterior.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

GrainSpectrum some_spectrum() {
  Grid<float> noise(96, 128);
  for (int row = 0; row < 96; ++row) {
    for (int col = 0; col < 128; ++col) noise(row, col) = float(gaussian(9, row, col));
  }
  return grain_spectrum(noise);
}

SequenceCandidate candidate(const std::string& sequence, const GrainSpectrum& spectrum, double cost,
                            HammerKernel kernel = HammerKernel::both) {
  return {grain_model(sequence, kernel, spectrum), {{}, cost}};
}

TEST(SequencePosterior, WeighsByTheLikelihood) {
  const auto spectrum = some_spectrum();
  const double nat = std::log(3.0);  // three times as likely
  const auto posterior = sequence_posterior(
      {candidate("CCCC", spectrum, 10.0 + nat), candidate("RRRR", spectrum, 10.0)}, spectrum, 1.0);
  ASSERT_EQ(posterior.classes.size(), 2u);
  EXPECT_EQ(posterior.likeliest.model.sequence, "RRRR");
  EXPECT_NEAR(posterior.classes[0].probability, 0.75, 1e-12);
  // Counted half, three nats are worth their root.
  const auto doubted = sequence_posterior(
      {candidate("CCCC", spectrum, 10.0 + nat), candidate("RRRR", spectrum, 10.0)}, spectrum, 2.0);
  EXPECT_NEAR(doubted.classes[0].probability, std::sqrt(3.0) / (1.0 + std::sqrt(3.0)), 1e-12);
}

TEST(SequencePosterior, AddsUpWhatIsThereTwice) {
  const auto spectrum = some_spectrum();
  const auto posterior =
      sequence_posterior({candidate("CCRR", spectrum, 5.0), candidate("RRRR", spectrum, 4.5),
                          candidate("CCRR", spectrum, 5.0)},
                         spectrum, 1.0);
  const double twice = 2.0 * std::exp(-0.5);
  EXPECT_EQ(posterior.classes[0].sequences.front(), "CCRR");
  EXPECT_NEAR(posterior.classes[0].probability, twice / (1.0 + twice), 1e-12);
}

TEST(SequencePosterior, ReportsAsOneWhatNoDataCanTellApart) {
  // Under a kernel along the stretched axis alone the order of the folds leaves no trace.
  const auto spectrum = some_spectrum();
  for (const auto kernel : {HammerKernel::stretched, HammerKernel::both}) {
    const auto posterior = sequence_posterior(
        {candidate("CRCR", spectrum, 1.0, kernel), candidate("CCRR", spectrum, 1.0, kernel),
         candidate("CCCR", spectrum, 1.0, kernel)},
        spectrum, 1.0);
    const bool blind = kernel == HammerKernel::stretched;
    ASSERT_EQ(posterior.classes.size(), blind ? 2u : 3u);
    EXPECT_EQ(posterior.classes[0].sequences.size(), blind ? 2u : 1u);
    EXPECT_NEAR(posterior.classes[0].probability, blind ? 2.0 / 3.0 : 1.0 / 3.0, 1e-12);
  }
}

TEST(SequencePosterior, GivesTheKindsTheirProbability) {
  const auto spectrum = some_spectrum();
  const auto posterior =
      sequence_posterior({candidate("CCCC", spectrum, 1.0), candidate("CCRC", spectrum, 1.0),
                          candidate("RRRC", spectrum, 1.0), candidate("CRRC", spectrum, 1.0)},
                         spectrum, 1.0);
  EXPECT_NEAR(posterior.kinds.masame, 0.25, 1e-12);
  EXPECT_NEAR(posterior.kinds.itame, 0.5, 1e-12);
  EXPECT_NEAR(posterior.kinds.mokume, 0.25, 1e-12);
}

TEST(SequencePosterior, KnowsTheKindsOfThePaper) {
  EXPECT_EQ(kind_of("CCCCCCCC"), "masame");
  EXPECT_EQ(kind_of("CRCRCRCRCRCR"), "mokume");
  for (const char* itame : {"CCRCCRCCR", "CRCCRCCRC", "RCCRCCRCC", "CRCRCRCCC"})
    EXPECT_EQ(kind_of(itame), "itame");
}

}  // namespace
}  // namespace hada
