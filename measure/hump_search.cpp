#include "measure/hump_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int directions = 12;
constexpr double frequency_step = 0.2;  // as a logarithm: a width of what is sought
constexpr double begun_along = 0.18, begun_across = 0.25;
constexpr std::size_t starts = 3;  // the steepest rise is not always the best

// Shapes that a further hump may begin with.
std::vector<SpectralHump> candidates(const HumpBounds& bounds) {
  std::vector<SpectralHump> result;
  for (double log_f = bounds.low[1] + std::log(2.0); log_f < bounds.high[1];
       log_f += frequency_step) {
    SpectralHump hump{0.0, log_f, std::log(begun_along), std::log(begun_across), 0.0, true};
    result.push_back(hump);
    hump.ring = false;
    for (int i = 0; i < directions; ++i) {
      hump.direction = pi * i / directions;
      result.push_back(hump);
    }
  }
  return result;
}

/// A hump that might be added to a mixture: how much the likelihood rises with its variance, in
/// standard deviations of chance, and how much variance the first step of a fit would give it.
struct Rise {
  double steepness = 0.0;
  SpectralHump hump;
};

Rise rise_of(SpectralHump hump, const std::vector<SpectralPatch>& patches,
             const std::vector<double>& expected) {
  constexpr double least_variance = 1e-3;  // of the step: a hump must have some to begin with
  const HumpDensity density(hump);
  double slope = 0.0, information = 1e-300;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const double share = density(patches[i].fx, patches[i].fy) / expected[i];
    slope += patches[i].count * share * (patches[i].power / expected[i] - 1.0);
    information += patches[i].count * share * share;
  }
  const double deviation = 1.0 / std::sqrt(information);
  hump.log_variance = std::log(std::max(slope / information, least_variance * deviation));
  return {slope * deviation, hump};
}

// The mixture with one hump more that is likeliest.
HumpFit with_another(const HumpMixture& mixture, const std::vector<SpectralPatch>& patches,
                     const HumpBounds& bounds) {
  const MixtureDensity density(mixture);
  std::vector<double> expected;
  for (const SpectralPatch& patch : patches) expected.push_back(density(patch.fx, patch.fy));
  std::vector<Rise> rises;
  for (const SpectralHump& hump : candidates(bounds))
    rises.push_back(rise_of(hump, patches, expected));
  std::stable_sort(rises.begin(), rises.end(),
                   [](const Rise& a, const Rise& b) { return a.steepness > b.steepness; });
  HumpFit best{mixture, HUGE_VAL};
  for (std::size_t i = 0; i < std::min(starts, rises.size()); ++i) {
    HumpMixture more = mixture;
    more.humps.push_back(rises[i].hump);
    HumpFit fit = fitted(more, patches, bounds);
    if (fit.deviance < best.deviance) best = fit;
  }
  return best;
}

// White noise as strong as the faintest, and a power law of the same power at the frequency in the
// middle.
HumpMixture ground_of(const std::vector<SpectralPatch>& patches) {
  std::vector<double> powers;
  double log_f = 0.0;
  for (const SpectralPatch& patch : patches) {
    powers.push_back(patch.power);
    log_f += 0.5 * std::log(patch.fx * patch.fx + patch.fy * patch.fy) / double(patches.size());
  }
  const auto faint = powers.begin() + std::ptrdiff_t(powers.size() / 10);
  std::nth_element(powers.begin(), faint, powers.end());
  HumpMixture ground;
  ground.log_floor = std::log(*faint);
  ground.log_fall = ground.log_floor + ground.steepness * log_f;
  return ground;
}

}  // namespace

HumpMixture humps_of(const SpectralPatches& patches, int most) {
  if (patches.all.empty()) return {};
  const HumpBounds bounds = hump_bounds(patches.extent);
  double ordinates = 0.0;
  for (const SpectralPatch& patch : patches.all) ordinates += patch.count;
  HumpFit best = fitted(ground_of(patches.all), patches.all, bounds);
  while (int(best.mixture.humps.size()) < most) {
    const HumpFit more = with_another(best.mixture, patches.all, bounds);
    const double price = 0.5 * more.mixture.humps.back().degrees_of_freedom() *
                         std::log(std::max(ordinates * patches.independence, 2.0));
    // Neighbouring ordinates of a tapered map are no independent witnesses.
    if (!(patches.independence * (best.deviance - more.deviance) > price)) break;
    best = more;
  }
  return best.mixture;
}

}  // namespace hada
