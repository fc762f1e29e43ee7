#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/surface.h"
#include "fit/fit.h"
#include "fit/sequence_search.h"
#include "synth/forged.h"

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

/// What a picture tells of how its steel was forged.
struct ForgedFit : Fit<Forged<>> {
  std::vector<SequenceClass> posterior;  // the likeliest first; sums to 1
  GrainKinds kinds;
  GrainNuisance nuisance;     // with the likeliest sequence
  double deviance = 0.0;      // per cell of the periodogram, 1 where the model is right
  GrainSpectrum spectrum;     // as measured
  std::vector<double> model;  // expected power of its cells
};

/// The fold sequences that explain the grain in `surface`, with their probabilities.
///
/// Tone and levels come from the histogram. The normal scores of the picture (or its grey values,
/// if these explain more) have a periodogram whose Whittle likelihood judges every sequence, with
/// the variance, blur, white noise and quantising that suit it best. All sequences of a length are
/// equally probable beforehand, and so are all lengths.
///
/// The picture has its columns along those of the block, at one place for a pixel.
/// throws  Error if the surface has neither albedo nor height, is smaller than 64 x 64 px, or is
///         all one grey
///
/// Source: Whittle, Ark. Mat. 2 (1953), over the spectrum of `synth/forged_spectrum.h`.
ForgedFit fit_forged(const Surface& surface, const SequenceSearchOptions& options = {});

}  // namespace hada
