#pragma once

#include "fit/fit.h"
#include "fit/observe.h"
#include "synth/wrinkle.h"

namespace hada {

/// The wrinkle noise whose spectrum is nearest in decibels to one that no wrinkle noise has.
///
/// A picture of cloth or bark is no sum of Gaussian kernels, and what is wanted of it is a texture
/// that looks alike at the same pitch: every frequency counts by its share of the plane, to the
/// corners of the square, and what its lens let through of finer ones is part of the picture.
///
/// first       another fit, to begin from
/// components  how many noise functions; 0: as many as pay for themselves, at most 5
/// returns     the best of many starts, the logarithm of whose model is nearest on average to that
/// of
///             the spectrum; sigma is widened by how far it stays away
Fit<Wrinkle<>> closest_wrinkle(const Observation& seen, const Fit<Wrinkle<>>& first,
                               int components);

}  // namespace hada
