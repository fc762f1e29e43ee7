#pragma once

#include <optional>
#include <string>
#include <vector>

#include "capture/calibrate.h"
#include "core/camera.h"

namespace hada {

/// By how much the spheres differ on the light of each picture, beyond what their places explain:
/// the widest angle between two of them, radians. None where fewer than two see it.
std::vector<std::optional<double>> disagreements(const Calibration& calibration,
                                                 const Camera& camera);

/// How far away the camera is, in the unit of its extent, if that is why spheres disagree.
///
/// A view that is not parallel turns all a sphere at (x, y) says about (-y, x, 0), by its place
/// over the distance. One number, 1/distance, is fitted to the differences between the spheres.
///
/// returns  nothing if the view is known to be a perspective, or if less than 70 % of the squared
///          differences are explained
std::optional<double> distance_that_explains(const Calibration& calibration, const Camera& camera);

/// Whether the spheres agree, in plain sentences: pictures on which they differ by more than 3
/// degrees and three times as much as on most, then by how much on the others, if it is over 3.
std::vector<std::string> remarks_on_agreement(const Calibration& calibration, const Camera& camera);

}  // namespace hada
