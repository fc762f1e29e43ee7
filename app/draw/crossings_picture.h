#pragma once

#include <vector>

#include "core/surface.h"
#include "mechanics/knit_net.h"

namespace hada {

/// A photograph, paler, with the net of the crossings that were found in it; those that were not
/// are missing.
///
/// places  in the frame of the photograph, course after course; not finite where not seen
Image crossings_picture(const Surface& photograph, int wales, const Places& places);

}  // namespace hada
