#pragma once

#include <Eigen/Core>

#include "app/draw/palette.h"
#include "core/image.h"

namespace hada {

/// Mixes a colour in where a round-ended line covers pixels.
///
/// a, b  (x, y) in pixels from the upper left corner, y down
/// half  the width, px
void draw_line(Image& picture, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double half,
               const Colour& colour);

}  // namespace hada
