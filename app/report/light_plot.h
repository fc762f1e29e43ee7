#pragma once

#include <string>
#include <vector>

#include "core/light_stack.h"

namespace hada {

/// The directions of the lights as seen from above: the middle is straight overhead, the rim the
/// horizon, rings every 30 degrees of tilt. Each dot carries its number and a disc of its standard
/// deviation, drawn `magnified` times so that it can be seen; further sets are drawn as rings.
struct LightSet {
  std::string name;
  std::vector<Light> lights;
};

std::string light_plot(const std::vector<LightSet>& sets, double magnified);

}  // namespace hada
