#pragma once

#include <string>

#include "reconstruct/reconstruct.h"

namespace hada {

/// What a surface folder remembers of its making, as a JSON object: noise, relighting error,
/// condition of the lights, remarks.
std::string surface_notes(const Reconstruction& reconstruction);

}  // namespace hada
