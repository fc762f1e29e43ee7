#pragma once

#include <string_view>

#include "core/grid.h"

namespace hada {

/// What is taken off a height map before anything is said about it.
enum class Levelling { offset, plane, quadratic };

std::string_view name_of(Levelling levelling);

/// Takes the best-fitting offset, plane or quadratic off `height` inside `mask`; what lies
/// outside becomes 0.
void level(Grid<float>& height, const Mask& mask, Levelling levelling);

}  // namespace hada
