#pragma once

#include <vector>

#include "core/surface.h"
#include "synth/bent_knit.h"

namespace hada {

/// What a stitch of each course of the colour repeat looks like: the mean over a picture at rest.
struct StitchLook {
  struct Sample {
    double wale, course;  // from the crossing, within half a stitch
    std::vector<float> values;
  };
  std::vector<std::vector<Sample>> courses;  // upward, from course 0 of `Knit`
};

/// A photograph as crossings are sought in it: square roots of brightness, smoothed.
struct TrackedPicture {
  Extent extent;
  std::vector<Grid<float>> planes;
};
TrackedPicture tracked_picture(const Surface& surface, double smooth_px);

/// knit  where the stitches of the picture lie, as `fit_knit` finds it
StitchLook look_of(const TrackedPicture& rest, const Knit<>& knit);

/// Which places of a knit are compared with its look.
struct ComparedPlaces {
  int every = 1;   // of the crossings, counted along the courses: each, every other one...
  int stride = 1;  // the same of the samples of a stitch
};

/// How alike the stitches at `bent` are to those of `look`: the mean of their correlations, 1 at
/// best; 0 where the picture ends.
///
/// first  the entry of the repeat that course 0 of `bent` is of
double mean_likeness(const TrackedPicture& picture, const StitchLook& look, const BentKnit& bent,
                     int first, const ComparedPlaces& compared = {});

/// The crossings of a knit in a picture of it pulled, from a guess that is right to a fifth of a
/// stitch; to a tenth or so of a stitch, since yarn is not drawn out as the look is.
///
/// Around each crossing the look of its stitch, bent as its neighbours say, is laid onto the
/// picture where it fits best, up to brightness and contrast: Gauss and Newton, each stitch in a
/// window of its own. In smooth pictures neighbours move together, in the last one each goes alone;
/// one that leaves its neighbours is put back among them.
///
/// levels  the same picture, smooth first, sharp last, with a look for each
///
/// Source: Pan, Meas. Sci. Technol. 29 (2018), digital image correlation of subsets; Westerweel and
/// Scarano, Exp. Fluids 39 (2005) for the test of neighbours.
BentKnit tracked(const std::vector<TrackedPicture>& levels, const std::vector<StitchLook>& looks,
                 const BentKnit& guess, int first);

}  // namespace hada
