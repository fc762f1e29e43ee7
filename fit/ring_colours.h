#pragma once

#include <array>
#include <vector>

#include "core/surface.h"
#include "fit/unrolled.h"

namespace hada {

/// How a ring changes its colour from early to late wood; see the fields of `Wood`.
struct RingColours {
  std::array<double, 3> early{}, late{};  // linear albedo
  double latewood_share = 0.35;
  double latewood_onset = 0.75;
};

struct RingColourFit {
  RingColours found;
  RingColours sigma;  // by leaving out parts of the picture, and what the pitch blurs
};

/// The colours of the rings between the first and the last of `radii` (at least two, rising).
///
/// surface  an albedo of one plane or three
RingColourFit ring_colours(const Surface& surface, const Mask& mask, const GrowthFrame& frame,
                           const std::vector<double>& radii);

}  // namespace hada
