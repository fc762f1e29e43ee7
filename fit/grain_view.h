#pragma once

#include <vector>

#include "fit/sequence_search.h"

namespace hada {

/// The grain of a picture, its tone undone and its rows turned level, and what may explain it.
struct SeenGrain {
  GrainSpectrum spectrum;
  std::vector<SequenceCandidate> candidates;  // at least one; a sequence may be there twice
  double rotation_rad = 0.0;  // by which the rows of the block run up, counter-clockwise
};

/// The sequences that may explain `grey`, seen as the block lies or, with `turned`, nearly so.
///
/// The tone is that of the normal scores, or linear if that explains more. All sequences have the
/// same axes, so that the picture is turned once for all: to where the spectrum is its own mirror
/// image and then, with the likeliest sequence, to where it is explained best; if that is worth
/// its own prior (normal, of 3 degrees). Candidates are sought at one pixel a place and, with
/// `turned`, at about one, both as probable beforehand.
/// options  the scale is not looked at
SeenGrain seen_grain(const Grid<float>& grey, const SequenceSearchOptions& options, bool turned);

}  // namespace hada
