#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "capture/evidence.h"

namespace hada {

/// What all pictures show of matte spheres where no lamp reaches: ambient light, or a black level
/// that is not zero. Red, green, blue; all 0 where it cannot be told from nothing.
///
/// On the dark side v = a + r t, where t is what table and sample throw there and r the sphere's
/// reflectance, shared by all pictures; a is what stays in every picture. It counts only where it
/// is above 0.2 % of a full light, beyond what the pictures differ by among each other, and above
/// a part of the thrown light, whose model is not better than that. Noise that was clipped at zero
/// has a mean but no median, so a is never more than the median of the pixels.
///
/// evidence  of linear photographs
/// readings  of their spheres
Eigen::Vector3d ambient_light(const Evidence& evidence, const std::vector<SphereReading>& readings,
                              const Camera& camera);

/// The grey value of red, green and blue.
double grey_of(const Eigen::Vector3d& channels);

/// What a matte sphere shows where it faces a lamp of ordinary strength, in grey.
double full_light(const SphereReading& reading);

/// Whether the dark side of a matte sphere shows enough for `ambient_light` to look at it: cheap.
bool shows_ambient(const SphereReading& reading);

/// Says that `share` of a full light was taken off all pictures, and what to do about it.
std::string remark_on_ambient(double share);

}  // namespace hada
