#pragma once

#include <functional>
#include <vector>

#include "core/surface.h"
#include "reconstruct/slopes.h"

namespace hada {

struct EdgeAwareOptions {
  double sharpness = 2.0;  // k of the sigmoid, 1 / px^2: how fast a pixel takes sides
  int max_rounds = 150;
  double least_change = 1e-4;  // relative, of the energy, where the rounds stop
  double tolerance_px = 1e-3;
  const Grid<float>* weight = nullptr;     // of the slope of each pixel, > 0: 1 over its variance
  std::function<void(int rounds)> done{};  // is told of every round
};

struct EdgeAware {
  Grid<float> height;          // in px, zero-mean in every region
  Grid<int> part;              // of a region cut at jumps, from 1; 0 outside the mask
  std::vector<int> part_size;  // in pixels; part_size[0] is not used
  double held_together = 1.0;  // share of the pixels in the largest part of their region
};

/// A height that may jump: each pixel takes its slope from the side to which it hangs together.
///
/// Along rows (and columns alike) a pixel has two equations, its slope p against the step to the
/// left and against the step to the right, weighted by m^2 s and m^2 (1 - s),
///
///     s = 1 / (1 + exp(-k ((m step_right)^2 - (m step_left)^2))),
///
/// so the side with the smaller step counts; both times the weight of the pixel, where there is
/// one. The steps are those of the last height; weights and height are found in turn, from equal
/// sides on.
///
/// Where jumps cut a part off all around, nothing says how high it lies over the rest:
/// `held_together` tells, and `place_parts` helps. A pair counts as cut where its weight is below
/// 0.3 of m^2, whatever its pixels weigh.
///
/// slopes, facing  as of `slopes_of` and `facing_of`
/// Source: X. Cao, H. Santo, B. Shi, F. Okura, Y. Matsushita, Bilateral normal integration, ECCV
/// 2022.
EdgeAware edge_aware_height(const SlopeMap& slopes, const Grid<float>& facing, const Mask& mask,
                            const EdgeAwareOptions& options = {});

/// Lifts every part as a whole to where `smooth`, a height without jumps, has it in the mean: that
/// lies between all that the part could be, and its shape stays its own.
///
/// smooth  in px, zero-mean in every region; so is the result
void place_parts(EdgeAware& found, const Grid<float>& smooth);

}  // namespace hada
