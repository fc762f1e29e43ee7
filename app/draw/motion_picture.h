#pragma once

#include <vector>

#include "core/image.h"

namespace hada {

/// How far the points of a knit move in each step, on a logarithmic axis, with the line below which
/// it counts as settled.
///
/// motion  of the first steps: the longest of any point, in wales
/// still   where it has settled
Image motion_picture(const std::vector<double>& motion, double still);

}  // namespace hada
