#pragma once

#include <string_view>

#include "core/grid.h"

namespace hada {

/// What is taken off a height map before anything is said about it; or what makes the long waves of
/// it: heights known from elsewhere (`prior_heights.h`).
enum class Levelling { offset, plane, quadratic, prior };

std::string_view name_of(Levelling levelling);

/// Takes the best-fitting offset, plane or quadratic off `height` inside `mask`; what lies
/// outside becomes 0. Not for `prior`.
void level(Grid<float>& height, const Mask& mask, Levelling levelling);

}  // namespace hada
