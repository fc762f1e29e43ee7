#pragma once

#include "core/random.h"
#include "core/surface.h"
#include "synth/blade.h"
#include "synth/forged.h"

namespace hada {

/// What one side of a blade shows: an eighth as high as it is long, row 0 at the back.
struct BladeSide {
  Grid<float> grain;  // etched, 0 to 1
  Grid<float> hard;   // 1 in the hardened edge, 0 above
  Surface surface;    // relief of the grain; the albedo is the reflectance at normal incidence
};

struct BladeLook {
  HamonShape hamon{.height = 0.0};
  AyasugiShape ayasugi;
};

/// cols  places along the blade
BladeSide blade_side(const Forged<>& forged, double length_mm, int cols, const BladeLook& look,
                     Seed seed);

}  // namespace hada
