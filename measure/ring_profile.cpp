#include "measure/ring_profile.h"

#include <algorithm>
#include <cmath>

#include "core/quantile.h"

namespace hada {
namespace {

/// A darkest place and the lightest that follows.
struct Rise {
  int dark;
  int light;
  double height;
};

/// Alternating extremes, first a dark one; swings of no height are left out.
std::vector<int> extremes(const std::vector<double>& values, double noise) {
  std::vector<int> places;  // dark, light, dark, ...
  int lowest = 0, highest = 0;
  bool seeking_light = false;
  for (int i = 0; i < int(values.size()); ++i) {
    const double here = values[std::size_t(i)];
    if (seeking_light) {
      if (here > values[std::size_t(highest)]) highest = i;
      if (here < values[std::size_t(highest)] - noise) {
        places.push_back(highest);
        lowest = i;
        seeking_light = false;
      }
    } else {
      if (here < values[std::size_t(lowest)]) lowest = i;
      if (here > values[std::size_t(lowest)] + noise) {
        places.push_back(lowest);
        highest = i;
        seeking_light = true;
      }
    }
  }
  if (seeking_light) places.push_back(highest);
  return places;
}

std::vector<Rise> rises_between(const std::vector<int>& places, const std::vector<double>& values) {
  std::vector<Rise> rises;
  for (std::size_t k = 0; k + 1 < places.size(); k += 2) {
    rises.push_back({places[k], places[k + 1],
                     values[std::size_t(places[k + 1])] - values[std::size_t(places[k])]});
  }
  return rises;
}

/// What is large among the values around number `k`.
double usual(const std::vector<double>& values, std::size_t k, int neighbours) {
  const std::size_t reach = std::size_t(neighbours);
  const auto from = values.begin() + std::ptrdiff_t(k > reach ? k - reach : 0);
  const auto to = values.begin() + std::ptrdiff_t(std::min(values.size(), k + reach + 1));
  return quantile(std::vector<double>(from, to), 0.6);
}

/// Takes out the smallest swing again and again, until each is worth mentioning beside the rises
/// around it; the extremes on both sides of a swing go with it.
void prune(std::vector<int>& places, const std::vector<double>& values,
           const RingProfileOptions& options) {
  while (places.size() > 3) {
    std::vector<double> heights;
    for (const Rise& rise : rises_between(places, values)) heights.push_back(rise.height);
    std::size_t worst = 0;
    double least = HUGE_VAL;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      const double swing =
          std::abs(values[std::size_t(places[k + 1])] - values[std::size_t(places[k])]);
      const double around = usual(heights, std::min(k / 2, heights.size() - 1), options.neighbours);
      if (swing / around < least) {
        least = swing / around;
        worst = k;
      }
    }
    if (least >= options.least_rise) return;
    // The first place stays dark and the last light: at the ends, a whole rise goes.
    if (worst == 0) {
      places.erase(places.begin(), places.begin() + 2);
    } else if (worst + 2 == places.size()) {
      places.resize(places.size() - 2);
    } else {
      const auto from = places.begin() + std::ptrdiff_t(worst);
      places.erase(from, from + 2);
    }
  }
}

RingBoundary steepest(const std::vector<double>& values, const Rise& rise) {
  const auto slope = [&](int i) {
    const std::size_t last = values.size() - 1, at = std::size_t(std::clamp(i, 0, int(last)));
    const std::size_t before = at > 0 ? at - 1 : 0, after = std::min(at + 1, last);
    return (values[after] - values[before]) / double(std::max<std::size_t>(after - before, 1));
  };
  int best = rise.dark;
  for (int i = rise.dark; i <= rise.light; ++i) {
    if (slope(i) > slope(best)) best = i;
  }
  const double before = slope(best - 1), here = slope(best), after = slope(best + 1);
  const double curvature = before - 2.0 * here + after;
  const double shift =
      curvature < 0.0 ? std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5) : 0.0;
  return {best + shift, rise.height, here};
}

}  // namespace

std::vector<RingBoundary> ring_boundaries(const std::vector<double>& brightness,
                                          const RingProfileOptions& options) {
  std::vector<int> places = extremes(brightness, options.noise);
  prune(places, brightness, options);
  std::vector<RingBoundary> boundaries;
  std::vector<double> slopes;
  for (const Rise& rise : rises_between(places, brightness)) {
    boundaries.push_back(steepest(brightness, rise));
    slopes.push_back(boundaries.back().slope);
  }
  std::vector<RingBoundary> kept;
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    if (slopes[k] >= options.least_slope * usual(slopes, k, options.neighbours))
      kept.push_back(boundaries[k]);
  }
  return kept;
}

}  // namespace hada
