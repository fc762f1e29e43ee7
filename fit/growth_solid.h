#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "fit/unrolled.h"
#include "synth/cut.h"
#include "synth/ripples.h"

namespace hada {

/// The growth of a stem in space, and how sure it is: the effective radius of any place, and at
/// which effective radii rings end.
///
/// rho = r (1 + lobes) + taper z + ripples, r the distance from the pith at the height z. Lengths
/// in the unit of the pictures, frame of `Wood`.
struct GrowthSolid {
  GrowthFrame frame;                // pith and lobes where z is 0
  Eigen::Vector2d lean{0.0, 0.0};   // of the pith, for each step of z
  double taper = 0.0;               // of the effective radius, for each step of z
  Ripples ripples;                  // none, unless the rings of the block wander
  std::vector<double> radii;        // effective radii where rings end, rising
  std::vector<double> radii_loose;  // of each: standard deviation of what is its own on a cut
  Eigen::MatrixXd covariance;       // of what `state` holds

  /// Pith, lean, taper, lobes, heights of the ripples, radii.
  Eigen::VectorXd state() const;
  void set_state(const Eigen::VectorXd& state);
  Eigen::Index lobes_at() const { return 5; }
  Eigen::Index ripples_at() const { return 5 + 2 * Eigen::Index(frame.lobes.size()); }
  Eigen::Index radii_at() const { return ripples_at() + Eigen::Index(ripples.orders().size()); }
  Eigen::Index size() const { return radii_at() + Eigen::Index(radii.size()); }
};

/// Median distance of rings that follow each other; infinite if there are fewer than two.
double usual_width(const GrowthSolid& solid);

/// What the solid says of one place.
struct SolidLocal {
  double rho = 0.0;
  Eigen::Vector3d gradient;  // of rho
  Eigen::VectorXd slopes;    // of rho with respect to the state before the radii; may be empty
};

SolidLocal local_of(const GrowthSolid& solid, const StemVector& place, bool with_slopes = true);

/// Standard deviation of rho - radii[ring] there.
double ring_sigma(const GrowthSolid& solid, const SolidLocal& local, std::size_t ring);

/// How fibres lean at a place of a cut, steps to the right for each step up, if they turn around
/// the stem by `turning` (the gradient G) and stay on their ring.
double fibre_slope(const GrowthSolid& solid, const Cut& cut, const Eigen::Vector2d& place,
                   double turning);

/// Standard deviation of rho there, radii left aside.
double rho_sigma(const GrowthSolid& solid, const SolidLocal& local);

}  // namespace hada
