#pragma once

#include <variant>

#include "synth/wrinkle.h"

namespace hada {

/// Every material that hada knows: the variant is the registry.
using Material = std::variant<Wrinkle<>>;

}  // namespace hada
