#pragma once

#include <string>
#include <vector>

#include "capture/load.h"
#include "core/light_stack.h"
#include "core/sphere.h"

namespace hada {

/// The lights that the manifest itself gives, one for each picture; empty if it gives none.
/// throws  Error if it gives some but not all
std::vector<Light> lights_in(const CaptureFile& file);

/// Lights from elsewhere, matched to these pictures by name or, where the names differ, by order.
/// throws  Error if there are not as many lights as pictures
std::vector<Light> matched_lights(const std::vector<Light>& lights, const CaptureFile& file);

/// The stack that reconstruction works on: linear pictures, lights, samples marked, sample found.
///
/// Samples are saturated where the file was at its largest value, shadowed where the value is lost
/// in the noise or far below what the other pictures predict. The mask is the owner's, or the
/// largest bright region that is no sphere (inside the sample box where one is given), shrunk by
/// one pixel. Strengths are scaled to a mean of 1 over lights and channels.
///
/// throws  Error for fewer than three pictures, or if no sample can be told from the background
LightStack light_stack(const Photographs& photographs, std::vector<Light> lights,
                       const std::vector<Sphere>& spheres);

}  // namespace hada
