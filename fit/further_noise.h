#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/random.h"
#include "fit/observe.h"
#include "synth/wrinkle.h"

namespace hada {

/// Bounds of a fit to a map of that pitch: nothing is seen there of kernels thinner than a tenth of
/// a pixel, nor a repetition within two. M is Wrinkle or one of its noise functions.
template <class M>
std::vector<SolverBounds> seen_bounds_of(const M& material, double pitch) {
  std::vector<SolverBounds> bounds;
  visit_fields(material, [&](const std::string&, const auto& field, const double&) {
    SolverBounds of_field = solver_bounds(field);
    const double pixels = field.name == "period_mm"                             ? 2.0
                          : field.name == "long_mm" || field.name == "short_mm" ? 0.1
                                                                                : 0.0;
    if (pixels > 0.0) of_field.low = std::max(of_field.low, std::log(pixels * pitch));
    bounds.push_back(of_field);
  });
  return bounds;
}

/// `wrinkle` with one more noise function, plain or repeated, that brings its spectrum nearer to
/// that of `seen` where the others stay as they are: several, the nearest first.
///
/// Repeated ones begin at the peaks of the cepstrum, with kernels of any size, shape and direction,
/// as plain ones do: `seed` draws them.
std::vector<Wrinkle<>> with_further_noise(const Wrinkle<>& wrinkle, const Observation& seen,
                                          Seed seed);

}  // namespace hada
