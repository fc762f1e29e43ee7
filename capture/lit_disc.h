#pragma once

#include <string>
#include <vector>

#include "capture/calibrate.h"
#include "capture/load.h"

namespace hada {

enum class DiscLight {
  good,
  weak,      // under a tenth of what most pictures show, or under 16 steps of the file
  shadowed,  // as dark, while the rest of the picture is lit as ever
  odd,       // not shaded like a sphere, though it is in most pictures
};

/// How one picture lights a matte sphere, against the others.
struct LitDisc {
  double strength = 0.0;  // of the shading
  double misfit = 1.0;    // as in `MatteShading`
  DiscLight light = DiscLight::good;
};

/// One for each picture.
///
/// A weak lamp makes the sphere and the picture around it dark; a shadow makes the sphere darker
/// than a quarter of what the picture around it lets expect. Odd is what leaves more than 30 % of
/// the contrast unexplained, and 2.5 times as much as usual.
///
/// linear  the photographs, with linear values
/// sphere  a matte one
std::vector<LitDisc> lit_discs(const Photographs& linear, const Sphere& sphere);

/// Takes back what matte spheres say of the light of pictures in which they lie in shadow, or are
/// oddly lit while another sphere sees that light well.
void leave_out_shadowed(const Photographs& linear, std::vector<SphereReading>& readings);

}  // namespace hada
