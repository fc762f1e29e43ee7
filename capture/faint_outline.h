#pragma once

#include <optional>

#include "capture/circle.h"
#include "core/grid.h"

namespace hada {

/// The outline of a mirror sphere around `start`, a circle somewhere on or inside it.
///
/// A mirror shows the table up to its very rim, so its outline is a faint step, while the mirrored
/// sheet and the dark mirrored room inside it have bold edges. What tells the outline is that the
/// step has one sign all the way round: the median over the radii of the slope along them is blind
/// to bold edges that cover part of the circle. Of all concentric steps the outermost counts.
///
/// picture     logarithms of brightness
/// radius_px   where a person has said it; then only the centre is sought
/// returns     nothing if no coherent step is found between 0.9 and 1.6 times the start's radius
std::optional<Circle> faint_outline(const Grid<float>& picture, const Circle& start,
                                    std::optional<double> radius_px);

}  // namespace hada
