#pragma once

#include "core/image.h"
#include "synth/bent_knit.h"

namespace hada {

struct KnitPhotographOptions {
  double unevenness = 0.01;  // of the place of a loop along each axis, in wales
  double mottle = 0.04;      // of the brightness of a loop, relative
  double noise = 0.01;       // of a pixel, over white
  int finer = 3;             // places that are rendered to a pixel, each way
};

/// A made photograph of a piece of knit on a dark table: linear, rounded to eight bits of sRGB.
///
/// The yarn runs smoothly through the crossings, of one radius everywhere; a lamp stands to the
/// upper left, and less light falls into the depth.
///
/// knit    its loop, yarns and colour repeat, upward from the lowest course
/// bent    places in the frame of the picture
/// throws  as `bent_loops` does
Image knit_photograph(const Knit<>& knit, const BentKnit& bent, const Extent& extent, Seed seed,
                      const KnitPhotographOptions& options = {});

}  // namespace hada
