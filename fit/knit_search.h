#pragma once

#include <vector>

#include "fit/knit_track.h"

namespace hada {

/// Where the crossings of a pulled piece lie about its middle, by the ratio of its yarns'
/// stiffness.
struct PulledShapes {
  std::vector<double> log_ratios;  // ascending
  std::vector<Places> places;      // of each

  /// Straight between the two nearest ratios.
  Places at(double log_ratio) const;
};

/// A piece of knit laid into a photograph, and how alike its stitches are there, 1 at best.
struct PlacedKnit {
  BentKnit bent;
  double likeness = -1.0;
};

/// Where a pulled piece lies in a photograph whose middle it covers to a stitch and a quarter,
/// turned by up to three degrees: the best places that are not the same, best first.
///
/// Stitches half a stitch aside look alike, too, so that all shapes, turns and shifts are compared
/// at a few places of some crossings; what is best there and not near a better one is moved, turned
/// and made of another ratio until nothing makes it more alike.
///
/// net    at rest; its stiffness is not read
/// first  the entry of the repeat that the lowest course is of
std::vector<PlacedKnit> placements(const TrackedPicture& picture, const StitchLook& look,
                                   const KnitNet& net, const PulledShapes& shapes, int first);

}  // namespace hada
