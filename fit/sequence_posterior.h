#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fit/sequence_search.h"

namespace hada {

/// Sequences that a picture of this size cannot tell apart, and how probable they are together.
struct SequenceClass {
  std::vector<std::string> sequences;  // the likeliest first
  double probability = 0.0;
};

/// The kinds of grain that sword smiths name: straight, plank, burl.
struct GrainKinds {
  double masame = 0.0;
  double itame = 0.0;
  double mokume = 0.0;
};

/// The kind by the folds: the longer the grain is drawn along one axis, the straighter it is.
///
/// With e = |number of C - number of R| / number of folds: mokume below 1/5, masame above 7/10,
/// itame between. The paper's examples have e = 0, 1 and 1/3.
std::string_view kind_of(const std::string& sequence);

struct SequencePosterior {
  std::vector<SequenceClass> classes;  // the likeliest first; sums to 1
  GrainKinds kinds;
  SequenceCandidate likeliest;  // of the first class
};

/// What the candidates of a search make of a picture.
///
/// A sequence may be a candidate more than once, at another scale: its probabilities add up.
/// Sequences whose spectra, each as it explains the picture best, differ by less than half a nat
/// belong to one class.
/// all      at least one
/// scatter  by which the likelihood counts less, at least 1
SequencePosterior sequence_posterior(const std::vector<SequenceCandidate>& all,
                                     const GrainSpectrum& spectrum, double scatter);

}  // namespace hada
