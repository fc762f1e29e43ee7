#pragma once

namespace hada {

/// What means over squares of side `pitch` leave of the amplitude of a wave: sinc X sinc Y with
/// X = pi fx pitch, Y = pi fy pitch.
double mean_amplitude(double fx, double fy, double pitch);

/// What is left of the amplitude of a wave of the height, after a camera has seen its slopes as
/// means over square pixels and the slopes were integrated with trapezoids.
///
/// fx, fy   cycles per unit, below Nyquist
/// returns  1 for long waves, falling to 0 at Nyquist; cos(pi fx pitch) for a wave along x
///
/// The pixel leaves `mean_amplitude`, sinc X sinc Y. Least squares over the
/// differences D, with slopes averaged over the two pixels of each, leaves
/// (X sin 2X + Y sin 2Y) / (2 (sin^2 X + sin^2 Y)).
double photographed_amplitude(double fx, double fy, double pitch);

/// What a lens leaves of the amplitude of a wave whose point spread is a Gaussian of standard
/// deviation `sigma`, in the unit of which frequencies are the inverse: exp(-2 pi^2 sigma^2 f^2).
double lens_amplitude(double fx, double fy, double sigma);

/// The power spectral density, in unit^4, that independent errors of the slopes of variance 1 at
/// every pixel become when the slopes are integrated with trapezoids: pitch^2 times (sin^2 2X +
/// sin^2 2Y) pitch^2 / (16 (sin^2 X + sin^2 Y)^2). Grows as 1 / f^2 towards long waves.
double integrated_noise(double fx, double fy, double pitch);

}  // namespace hada
