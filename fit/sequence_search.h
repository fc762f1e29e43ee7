#pragma once

#include <string>
#include <vector>

#include "fit/grain_nuisance.h"

namespace hada {

/// One sequence, and how well it explains a periodogram.
struct SequenceCandidate {
  GrainModel model;
  GrainFit fit;

  /// Negative logarithm of what the likelihood and the prior make of it, in nats up to a constant:
  /// all lengths are equally probable beforehand, and so are all sequences of one length.
  ///
  /// scatter  of the likelihood, 1 if the model is right; a larger one takes weight from it
  double loss(double scatter = 1.0) const;
};

struct SequenceSearchOptions {
  int fewest_folds = 2;
  int most_folds = 12;
  HammerKernel kernel = HammerKernel::both;
  int refined = 16;  // sequences whose nuisance is fitted anew
  GrainScale scale = GrainScale::one;
};

/// Nuisances from which some sequence explains the periodogram best; no beam yet.
///
/// For every number of cuts along both axes the even mixture and the two that make all cuts of one
/// kind first; of an unknown scale, at the best of several.
std::vector<SequenceCandidate> first_guesses(const GrainSpectrum& spectrum,
                                             const SequenceSearchOptions& options);

/// The first `most` candidates, their nuisance fitted from where it is with these options.
std::vector<SequenceCandidate> refitted(std::vector<SequenceCandidate> candidates, std::size_t most,
                                        const GrainSpectrum& spectrum,
                                        const SequenceSearchOptions& options);

/// The likeliest sequences and many others, the likeliest first: a beam search from `guesses` over
/// letters that are flipped, put in, left out, or change places.
std::vector<SequenceCandidate> likely_sequences(std::vector<SequenceCandidate> guesses,
                                                const GrainSpectrum& spectrum,
                                                const SequenceSearchOptions& options);

}  // namespace hada
