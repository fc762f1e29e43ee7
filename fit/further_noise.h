#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/random.h"
#include "fit/observe.h"
#include "synth/wrinkle.h"

namespace hada {

/// What a map can show of a field that is a length, as the bounds of a solver: no kernel thinner
/// than a tenth of a pixel or longer than the map, no repetition within two pixels or further off
/// than half the map.
template <class F>
SolverBounds seen_bounds(const F& field, const Extent& extent) {
  auto [low, high] = solver_bounds(field);
  if (field.name == "long_mm" || field.name == "short_mm") {
    low = std::max(low, std::log(0.1 * extent.pitch));
    high = std::min(high, std::log(std::max(extent.width(), extent.height())));
  } else if (field.name == "period_mm" || field.name == "other_period_mm") {
    low = std::max(low, std::log(2.0 * extent.pitch));
    high = std::min(high, std::log(0.5 * std::min(extent.width(), extent.height())));
  }
  return {low, high};
}

/// Of all fields. M is Wrinkle or one of its noise functions.
template <class M>
std::vector<SolverBounds> seen_bounds_of(const M& material, const Extent& extent) {
  std::vector<SolverBounds> bounds;
  visit_fields(material, [&](const std::string&, const auto& field, const double&) {
    bounds.push_back(seen_bounds(field, extent));
  });
  return bounds;
}

/// How many periods the noise functions of `wrinkle` come back after.
int periods(const Wrinkle<>& wrinkle);

/// What a search goes by. A noise function must be seen to come back: lines too faint for a
/// hundredth of the cost are a plain one's, of another shape.
double weighed(double cost, const Wrinkle<>& wrinkle);

/// `wrinkle` with one more noise function, plain, repeated or woven, that brings its spectrum
/// nearer to that of `seen` where the others stay as they are: several, the nearest first.
///
/// Repeated ones begin at the peaks of the cepstrum, woven ones at pairs of them, with kernels of
/// any size, shape and direction, as plain ones do: `seed` draws them.
std::vector<Wrinkle<>> with_further_noise(const Wrinkle<>& wrinkle, const Observation& seen,
                                          Seed seed);

}  // namespace hada
