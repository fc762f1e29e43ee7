#pragma once

#include <vector>

#include "fit/solid_fit.h"

namespace hada {

/// How rough and how high the ripples of a stem are taken to be: a Gaussian process.
struct RipplePrior {
  double height = 0.0;  // standard deviation of rho, in the unit of the pictures; 0: no ripples
  double across = 1.0;  // correlation length along x and y
  double along = 1.0;   // the same along the stem, z
  double gain = 0.0;    // by which its evidence is better than that of no ripples
};

/// The waves that a process in `box` is made of, long ones first.
Ripples ripples_in(const Ripples::Box& box, int count);

/// Standard deviation of the height of every wave, of a process of Matern's covariance of order
/// 3/2: as rough as rings are, with long waves that are higher than short ones.
///
/// Source: Solin and Sarkka, Statistics and Computing 30 (2020), section 3; cosines for a free
/// boundary. Rasmussen and Williams (2006), equation 4.15.
std::vector<double> wave_sigma(const Ripples& ripples, const RipplePrior& prior);

/// The prior that the sightings make most likely, by climbing from several; the noise of the
/// sightings is climbed as well.
///
/// solid   with the waves, fitted with any prior; `equations` are those at its end
RipplePrior likely_ripples(const GrowthSolid& solid, const SolidEquations& equations,
                           const std::vector<RipplePrior>& starts);

}  // namespace hada
