#pragma once

#include <string>
#include <vector>

#include "core/light_stack.h"
#include "reconstruct/normals.h"

namespace hada {

/// What is poor about normals that were found with uncertainty, and what would help: sentences for
/// a person.
std::vector<std::string> remarks_on(const LightStack& stack, const Orientation& found);

}  // namespace hada
