#pragma once

#include <optional>
#include <vector>

#include "core/surface.h"
#include "fit/dark_discs.h"
#include "fit/unrolled.h"

namespace hada {

/// What is darker than the wood at the same effective radius nearby.
struct DarkWood {
  Grid<float> dark;         // 0 in wood, 1 in vessels, between where a pixel sees both; else NaN
  double depth = 0.0;       // what a vessel takes away of the brightness of the wood
  double scatter = 0.0;     // of wood about its usual brightness, a share of that
  std::vector<Disc> discs;  // vessels, in px
};

/// Vessels of an end grain whose rings run along `frame`; nothing where it shows fewer than ten,
/// where they take less than 0.2 % of it, or where they are smaller than 4 px. The frame may be a
/// rough one: only arcs of 150 px follow it.
std::optional<DarkWood> dark_wood(const Grid<float>& brightness, const Mask& wood,
                                  const GrowthFrame& frame, const Extent& extent);

}  // namespace hada
