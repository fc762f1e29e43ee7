#pragma once

#include <span>
#include <vector>

#include "fit/unrolled.h"

namespace hada {

/// Where, in one sector, dark latewood meets the light earlywood of the next ring outward.
struct RingEdge {
  int sector;
  double rho;       // effective radius, in the unit of the picture
  double strength;  // slope of the smoothed values, per px
};

/// Edges of every sector, from the pith outward. Faint ones, beside what is usual nearby, are left
/// out; so are those less than `blur_px` from where the wood ends.
///
/// blur_px  standard deviation of the Gaussian that the values are smoothed by
std::vector<std::vector<RingEdge>> ring_edges(const Unrolled& flat, double pitch,
                                              double blur_px = 1.6);

/// The slopes of one sector of `flat`, per px, of values smoothed by a Gaussian; NaN where its
/// kernel sees what is no wood.
std::vector<double> slopes_along(std::span<const float> values, double step_px, double blur_px);

/// `edge` moved to where the values cross the middle between the dark before and the light after
/// it: unlike the steepest place, that does not depend on how fast the latewood darkened.
RingEdge middle_of_rise(const RingEdge& edge, const Unrolled& flat, double pitch);

/// The same of a profile: `index` moved, in samples that lie `step_px` apart.
double middle_of_rise(std::span<const float> values, double index, double step_px);

/// Edges that follow each other from sector to sector: pieces of one ring.
using RingChain = std::vector<RingEdge>;

/// Chains of at least `fewest` edges that sectors see on their own: those that were averaged with
/// their neighbours count as one. An edge goes on in the next sector, or the one after it, where
/// the nearest is nearer than a fifth of the usual distance between rings.
std::vector<RingChain> ring_chains(const std::vector<std::vector<RingEdge>>& edges,
                                   const Unrolled& flat, double pitch, int fewest = 4);

}  // namespace hada
