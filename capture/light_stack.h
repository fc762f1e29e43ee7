#pragma once

#include <string>
#include <vector>

#include "capture/load.h"
#include "core/light_stack.h"
#include "core/sphere.h"
#include "io/lights_file.h"

namespace hada {

/// The lights that the manifest itself gives, one for each picture; empty if it gives none.
/// throws  Error if it gives some but not all
std::vector<Light> lights_in(const CaptureFile& file);

/// Lights from elsewhere, matched to these pictures by name, else by name without its ending (a
/// dome's JPEGs were calibrated, its TIFFs are measured), else by order.
/// throws  Error if there are not as many lights as pictures
std::vector<Light> matched_lights(const std::vector<Light>& lights, const CaptureFile& file);

/// The same for all that a lights file holds: the error modes follow their lights.
/// throws  Error as above, or if near lights stand in another unit than that of the pictures
LightsFile matched_lights(LightsFile lights, const Photographs& photographs);

/// The stack that reconstruction works on: linear pictures, lights, samples marked, sample found.
///
/// Samples are saturated where the file was at its largest value, shadowed where hardly any light
/// arrives (below the noise, or below 3 % of the pixel's brightest). The mask is the owner's, or
/// the one that `sample_mask` finds. Strengths are scaled to a mean of 1 over lights and channels.
///
/// photographs  as loaded; what `linear` says of them is believed
/// spheres      no part of the sample
/// throws       Error for fewer than three pictures, or if no sample stands out from the background
LightStack light_stack(Photographs photographs, std::vector<Light> lights,
                       const std::vector<Sphere>& spheres);

}  // namespace hada
