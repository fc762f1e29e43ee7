#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/extent.h"
#include "core/grid.h"

namespace hada {

/// The corners of the largest region of a mask, counter-clockwise, its sides fitted by straight
/// lines. In the frame of `extent`.
///
/// throws  Error if the mask is empty
std::vector<Eigen::Vector2d> outline_of(const Mask& mask, const Extent& extent);

}  // namespace hada
