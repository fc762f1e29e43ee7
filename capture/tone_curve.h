#pragma once

#include <string>
#include <vector>

#include "capture/calibrate.h"
#include "capture/load.h"

namespace hada {

/// Whether a tone curve is left in the pictures: the exponent under which a Lambert sphere explains
/// the matte spheres best, if it is further than a fifth from 1 and a third better than 1.
///
/// linear  the photographs, with values that are taken as linear
std::vector<std::string> remarks_on_curve(const Photographs& linear,
                                          const Calibration& calibration);

}  // namespace hada
