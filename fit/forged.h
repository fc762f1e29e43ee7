#pragma once

#include <vector>

#include "core/surface.h"
#include "fit/fit.h"
#include "fit/sequence_posterior.h"
#include "synth/forged.h"

namespace hada {

/// Whether a picture shows the block as it lies, one place a pixel, or may be a little turned,
/// scaled and stretched.
enum class GrainView { automatic, block };

struct ForgedFitOptions {
  int fewest_folds = 2;
  int most_folds = 12;
  HammerKernel kernel = HammerKernel::both;
  GrainView view = GrainView::automatic;
};

/// What a picture tells of how its steel was forged.
struct ForgedFit : Fit<Forged<>> {
  std::vector<SequenceClass> posterior;  // the likeliest first; sums to 1
  GrainKinds kinds;
  GrainNuisance nuisance;     // with the likeliest sequence
  double rotation_rad = 0.0;  // of the rows of the block, counter-clockwise
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
/// The rows of the block may run up to 12 degrees off those of the picture, and a place may be a
/// little more or less than a pixel (GrainScale::about_one); that it is one pixel is as probable
/// beforehand as all that together.
/// throws  Error if the surface has neither albedo nor height, is smaller than 64 x 64 px, or is
///         all one grey
///
/// Source: Whittle, Ark. Mat. 2 (1953), over the spectrum of `synth/forged_spectrum.h`.
ForgedFit fit_forged(const Surface& surface, const ForgedFitOptions& options = {});

}  // namespace hada
