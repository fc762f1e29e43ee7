#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "measure/spectrum.h"

namespace hada {

/// Distances after which a map comes back, the most pronounced first: peaks of the cepstrum, the
/// inverse transform of the logarithm of the power over what `expected` says of it at (fx, fy).
///
/// A repetition ripples the logarithm of a spectrum wherever the spectrum is high or low, so that
/// even one that holds little power stands out. One of each pair +p and -p.
///
/// spectrum           of a map that is not flat
/// shortest, longest  of the distances, in units of the map; found between its pixels
/// most               of them
/// Source: Bogert, Healy, Tukey, The quefrency alanysis of time series for echoes, 1963.
std::vector<Eigen::Vector2d> repetitions(
    const Spectrum& spectrum, const std::function<double(double fx, double fy)>& expected,
    double shortest, double longest, int most);

}  // namespace hada
