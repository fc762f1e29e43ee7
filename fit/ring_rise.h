#pragma once

#include <vector>

#include "fit/ring_edges.h"
#include "fit/unrolled.h"

namespace hada {

/// How far before the middle of its rise a ring begins, beside its width; 0 if that cannot be told
/// from how sharp the picture is.
struct RingRise {
  double share = 0.0;
  double sigma = 0.0;
};

/// By how much rings begin before the middle of their rise, and standard deviations.
struct RingOnset {
  std::vector<double> before, sigma;  // ring by ring, in the unit of the radii
};

/// The rise at the boundaries of an end grain.
///
/// What the picture blurs is as wide at every boundary, what the wood takes grows with the ring:
/// the variance of the rises is a straight line over the square of the widths. An even rise begins
/// sqrt(3) of its standard deviations before its middle, a smooth step sqrt(5): half way, and the
/// sigma has both. Noise widens all rises alike.
///
/// rings  the edges of each, moved to the middle of their rise
/// radii  of the same rings, rising
/// flat   logarithms of brightness
RingRise ring_rise(const std::vector<RingChain>& rings, const std::vector<double>& radii,
                   const Unrolled& flat);

/// Where the rise begins, and with it the new year; radii less that are still rising and positive.
///
/// The ring of the last radius, of which nothing is seen, is taken to be as wide as the one before.
RingOnset onset_of(const RingRise& rise, const std::vector<double>& radii);

}  // namespace hada
