#pragma once

#include <optional>
#include <string>
#include <vector>

#include "capture/load.h"
#include "core/light_stack.h"

namespace hada {

/// Settles whether pictures of unknown encoding are linear, by which reading lets the lights
/// explain the brightness of the pixels better; says so in the remarks. Does nothing where it is
/// known.
///
/// lights  one for each picture; with fewer than four nothing is left over to tell by
void settle_encoding(Photographs& photographs, const std::vector<Light>& lights);

/// The sentence that doubts that pictures are linear, although a person or their 16 bits say so:
/// if lights explain them far better with the sRGB curve undone.
///
/// lights  given with their strengths, not bent to what the brightness of this sample wants
std::optional<std::string> doubt_of_linear(const Photographs& photographs,
                                           const std::vector<Light>& lights);

}  // namespace hada
