#pragma once

#include <optional>

#include "app/comparison.h"

namespace hada {

/// Where two surfaces lie over each other, and how far they differ there.
///
/// Maps of equal size that were not cut out of pictures lie over each other as they are; others by
/// the place of their first pixel in the pictures.
/// returns  nothing if the pitches differ or fewer than 16 pixels count in both
std::optional<Overlap> overlap(const Surface& first, const Surface& second);

}  // namespace hada
