#pragma once

#include <string>
#include <vector>

#include "capture/calibrate.h"
#include "capture/load.h"
#include "core/light_stack.h"

/// What is wrong with a capture, in plain sentences: what, in which picture, and what to do. A good
/// capture has none.
namespace hada {

/// Where the lights stand: all within 20 degrees of the camera's axis, all lower than 20 degrees
/// above the table, all within less than a half turn around the sample, or two of them closer than
/// 2 degrees to each other. Lights within 10 degrees of the axis belong to no side.
std::vector<std::string> remarks_on_lights(const std::vector<Light>& lights);

/// Whether the spheres can be believed: too small, not shaded like one, at odds with each other; in
/// single pictures without a light, dark, in the shadow of something, or clipped.
///
/// linear  the photographs, with linear values
std::vector<std::string> remarks_on_spheres(const Photographs& linear,
                                            const Calibration& calibration);

/// Which pictures show more than 1 % of the sample at the largest value of their file.
std::vector<std::string> remarks_on_clipping(const LightStack& stack);

}  // namespace hada
