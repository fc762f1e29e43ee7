#pragma once

#include <array>
#include <string>

namespace hada {

/// Red, green, blue as a screen takes them (sRGB curve on), each in [0, 1].
using Colour = std::array<float, 3>;

/// Dark blue (0) over teal to light yellow (1): perceived lightness grows evenly, also for eyes
/// that do not tell red from green. For a quantity without a meaningful zero.
Colour sequential(double share);

/// Blue (-1) over near white (0) to orange (1), equally light at equal distance from 0.
Colour diverging(double share);

/// The colour as CSS and SVG write it, "#rrggbb".
std::string css(const Colour& colour);

}  // namespace hada
