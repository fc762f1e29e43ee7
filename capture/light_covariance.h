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

/// By how much better near lamps explain the evidence than distant ones, in units of twice the
/// logarithm of a likelihood, both states under the noise levels of `near`'s descent.
///
/// Residuals that hang together count as fewer than they are: what sheen, dust or clipped noise
/// leave is no sign of a near lamp because some distance takes up a part of it. The heights of the
/// sheet, which distant lamps do not see, take up noise by luck; the expected share,
/// ln(1 + s^2) for each pixel whose height is known s times better than before, is taken off.
/// Negative where the matte spheres or the sheet by themselves speak against near lamps: a lamp
/// that is near is so for both.
double gain_of_nearness(JointState& distant, JointState& near, const Evidence& evidence);

}  // namespace hada
