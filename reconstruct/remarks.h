#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/light_stack.h"
#include "reconstruct/normals.h"

namespace hada {

/// What is poor about normals that were found with uncertainty, and what would help: sentences for
/// a person.
std::vector<std::string> remarks_on(const LightStack& stack, const Orientation& found);

/// The sentence that says that large parts of a mask do not hang together, if they do not.
std::optional<std::string> remark_on_regions(const Mask& mask);

}  // namespace hada
