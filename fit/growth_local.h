#pragma once

#include <Eigen/Core>

#include "fit/unrolled.h"

namespace hada {

// A growth frame as a vector: x and y of the pith, then cosine and sine of each lobe.

Eigen::VectorXd packed(const GrowthFrame& frame);
GrowthFrame unpacked(GrowthFrame frame, const Eigen::VectorXd& state);

/// Effective radius of a place, and its derivatives with respect to the packed frame; those of the
/// pith are minus those of the place.
struct GrowthLocal {
  double rho = 0.0;
  Eigen::VectorXd slopes;
};

GrowthLocal growth_at(const GrowthFrame& frame, const Eigen::Vector2d& place);

/// The same for many places: `slopes` has a column for each; what comes back is the radius.
double growth_at(const GrowthFrame& frame, const Eigen::Vector2d& place,
                 Eigen::MatrixXd::ColXpr slopes);

/// 1 over the variance that ordinary wood leaves each entry: nothing is known of a pith, and lobes
/// are small.
Eigen::VectorXd growth_prior(const GrowthFrame& frame);

}  // namespace hada
