#pragma once

#include <Eigen/Core>

#include "capture/joint_fit.h"

namespace hada {

/// The covariance of the lights at the minimum of a joint fit: of what arrives at `point` from
/// each, three numbers for every light one below the other, in units of the mean strength.
///
/// Spheres, reflectances and the sheet are marginalised, and the common scale is taken off.
/// Residuals that hang together count as fewer: each kind of evidence is weighted down by the
/// variance of the sums over its clusters, over that of independent residuals (the design effect of
/// Kish, Survey Sampling, 1965).
///
/// state  is not changed; Ceres asks for places that it could write to
Eigen::MatrixXd arriving_covariance(JointState& state, const Evidence& evidence, LampModel model,
                                    const Eigen::Vector3d& point);

}  // namespace hada
