#pragma once

#include <string>
#include <vector>

#include "capture/load.h"
#include "core/light_stack.h"
#include "core/sphere.h"

namespace hada {

/// What the spheres beside the sample say of lights that were not read off them: a sentence for
/// each sphere that sees them elsewhere, by more than it is unsure of and by more than a person
/// would put up with. Lights of another day, in another order, or of a rig that was moved.
///
/// photographs  as loaded, their encoding known
/// lights       one for each picture
std::vector<std::string> remarks_on_given_lights(const Photographs& photographs,
                                                 const std::vector<Light>& lights,
                                                 const std::vector<Sphere>& spheres);

}  // namespace hada
