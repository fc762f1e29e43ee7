#pragma once

#include "synth/wrinkle.h"

namespace hada {

/// The covariance of the slopes along x and y.
struct SlopeCovariance {
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

/// What the normals of a map of `pitch` leave out of the slopes of a sheet: all of them, less those
/// of central differences over two pixels (`normals_of`), in closed form from the autocovariance.
///
/// The floor is left out: white noise has no slope of its own, and it is of the measurement.
SlopeCovariance unresolved_slopes(const Wrinkle<>& wrinkle, double pitch);

/// The roughness that a renderer needs so that light is scattered by slopes that a map leaves out:
/// the square root of alpha of a microfacet distribution, alpha^2 twice the mean variance of a
/// slope; 0 is a mirror, 1 the roughest.
///
/// Source: Beckmann and Spizzichino 1963 (alpha is root 2 times the rms slope); Olano and Baker,
/// LEAN mapping, I3D 2010; Burley 2012 (roughness is the root of alpha).
double roughness_of(const SlopeCovariance& slopes);

}  // namespace hada
