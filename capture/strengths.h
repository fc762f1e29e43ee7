#pragma once

#include <vector>

#include "core/light_stack.h"

namespace hada {

/// Scales the lights of `stack` so that the sample itself agrees on their strengths.
///
/// For chrome spheres, whose highlights clip: I_k = s_k rho (l_k . n) is linear in rho n for given
/// strengths and in the strengths for given rho n; the two are solved in turn from the strengths in
/// force, over pixels that every light reaches, without those that fit worst. What the sample
/// cannot tell (a flat sheet leaves three combinations free) stays as it was. Mean over the
/// lights 1.
///
/// Such pixels also tell the colours of the lamps (`lamp_colours`). Fewer than five lights or than
/// 100 pixels tell nothing more.
///
/// returns  whether the sample could tell
bool balance_strengths(LightStack& stack);

/// The error modes of lights whose strengths nobody knows: each by itself may be off by a fifth.
std::vector<LightErrorMode> unknown_strengths(const std::vector<Light>& lights);

}  // namespace hada
