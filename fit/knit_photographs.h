#pragma once

#include <vector>

#include "core/surface.h"
#include "fit/knit_stiffness.h"
#include "synth/knit.h"

namespace hada {

/// A photograph of a piece of knit that clamps have pulled to a known stretch.
struct KnitPhotograph {
  Surface picture;  // its albedo, linear; of about the pitch of the picture at rest
  KnitPull pull = KnitPull::wale;
  double stretch = 1.5;
};

/// The piece between its clamps, those stitches included that they hold.
struct KnitPiece {
  int courses = 0;
  int wales = 0;
  KnitClamp clamp = KnitClamp::three_points;
};

/// What photographs of a pulled knit tell.
struct PulledKnitFit {
  KnitNet net;              // at rest, of the piece
  std::vector<int> repeat;  // of its courses, upward from the lowest: 0 nylon, else support
  KnitStiffness stiffness;
  std::vector<KnitState> states;  // places in the frames of the pictures; not finite: not seen
  std::vector<std::vector<double>> likeness;  // of each crossing in each photograph, 1 at best
  std::vector<std::string> remarks;
};

/// Stiffness ratio and yarn coefficient of a knit from photographs of one piece, pulled.
///
/// Where the piece lies is found by comparing what the stitches at rest look like with the
/// photograph at the rests of several knits (soft, stiff, even), begun with each course of the
/// repeat (`placements`); from there the crossings are tracked (`tracked`), then refined by drawing
/// their loops (`refined`), and the beginning counts whose drawn loops are most like all
/// photographs; the rest under both forces is fitted to them, seen up to shift, turn and scale.
///
/// rest    a picture of the same knit at rest, filled by it
/// knit    what `fit_knit` found in it
/// repeat  which courses are of support yarn (1), which of nylon (0), upward from course 0 of
///         `knit`; as long as its colour repeat, or more where one colour is all there is
/// throws  Error if there is no photograph, if the crossings of one are not found, or if those that
///         are found lie further off those of any knit pulled so than stitches are uneven
PulledKnitFit fit_photographs(const Surface& rest, const Knit<>& knit,
                              const std::vector<int>& repeat,
                              const std::vector<KnitPhotograph>& photographs,
                              const KnitPiece& piece);

}  // namespace hada
