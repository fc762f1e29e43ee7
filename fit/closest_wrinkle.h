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
/// Noise functions are added one at a time, plain ones and repeated ones (cloth comes back after
/// each thread), each from many starts with the others held and then with all free; then each is
/// taken out in turn and another sought.
///
/// functions  how many; 0: as many as pay for themselves, at most 5
/// returns    the nearest that was found, plain or repeated; its variance has a twentieth of the
/// say
///            of all frequencies. Sigma is widened by how far it stays away
/// throws     Error if no search stays with finite numbers
Fit<Wrinkle<>> closest_wrinkle(const Observation& seen, int functions,
                               const FitProgress& progress = {});

}  // namespace hada
