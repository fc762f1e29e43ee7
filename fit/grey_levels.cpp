#include "fit/grey_levels.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/quantile.h"

namespace hada {
namespace {

constexpr double finest_step = 2.0;  // an 8-bit picture has a comb of its own at 1
constexpr double bins_per_grey = 16.0;
constexpr double faintest_line = 0.05;  // of the characteristic function
constexpr double same_line = 0.6;       // of the strongest: its overtones are not much weaker
constexpr double exact = 0.1;           // share of a step off the teeth, where there is no noise
constexpr double block_places = 2048.0 * 16384.0;
constexpr double extreme_scatter = 0.08;  // of the extremes of a block, from seed to seed
constexpr double tail = 1e-4;  // share of pixels that noise may lift beyond the last tooth

struct Moments {
  double mean;
  double deviation;
};

Moments moments_of(const Grid<float>& grey) {
  double sum = 0.0, squares = 0.0;
  for (const float g : grey) sum += g;
  const double mean = sum / double(grey.size());
  for (const float g : grey) squares += (g - mean) * (g - mean);
  return {mean, std::sqrt(squares / double(grey.size()))};
}

class Characteristic {
 public:
  explicit Characteristic(const Grid<float>& grey) : total_(double(grey.size())) {
    const auto [low, high] = std::minmax_element(grey.begin(), grey.end());
    low_ = *low;
    count_.assign(std::size_t((*high - *low) * bins_per_grey) + 2, 0.0);
    for (const float g : grey) count_[std::size_t((g - *low) * bins_per_grey + 0.5)] += 1.0;
  }
  std::complex<double> operator()(double u) const {
    const auto turn = std::polar(1.0, 2.0 * std::numbers::pi * u / bins_per_grey);
    std::complex<double> phase = std::polar(1.0, 2.0 * std::numbers::pi * u * low_), sum = 0.0;
    for (const double count : count_) {
      sum += count * phase;
      phase *= turn;
    }
    return sum / total_;
  }

 private:
  double total_;
  double low_;
  std::vector<double> count_;
};

/// The frequency near `u` at which the characteristic function is largest.
double summit(const Characteristic& at, double u, double step) {
  for (int pass = 0; pass < 4; ++pass, step *= 0.1) {
    const double before = std::abs(at(u - step)), here = std::abs(at(u));
    const double after = std::abs(at(u + step)), bend = before - 2.0 * here + after;
    if (bend < 0.0) u += step * std::clamp(0.5 * (before - after) / bend, -1.0, 1.0);
  }
  return u;
}

/// The lowest frequency of a comb, 0 if there is none.
double line_of(const Characteristic& at, double deviation, double range) {
  // Below `first` it is the distribution as a whole that is seen.
  const double first = 0.62 / deviation, step = 0.1 / range;
  std::vector<double> strength;
  for (double u = first; u <= 1.0 / finest_step; u += step) strength.push_back(std::abs(at(u)));
  if (strength.size() < 3) return 0.0;
  const double strongest = *std::max_element(strength.begin(), strength.end());
  if (strongest < faintest_line) return 0.0;
  for (std::size_t k = 1; k + 1 < strength.size(); ++k) {
    const double before = strength[k - 1], here = strength[k], after = strength[k + 1];
    if (here < same_line * strongest || here < before || here < after) continue;
    return summit(at, first + double(k) * step, step);
  }
  return 0.0;
}

}  // namespace

GreyLevels grey_levels(const Grid<float>& grey, int folds) {
  const auto [lowest, highest] = std::minmax_element(grey.begin(), grey.end());
  const double low = *lowest, high = *highest;
  const Moments moments = moments_of(grey);
  const double deviation = moments.deviation;
  GreyLevels levels;
  levels.highest = high - low;
  levels.highest_sigma = deviation;
  if (!(deviation > 0.0)) return levels;
  const Characteristic at(grey);
  const double line = line_of(at, deviation, high - low);
  if (line <= 0.0) return levels;
  // A tooth moves by the noise of the mean of what stands on it.
  const double strength = std::abs(at(line));
  const double blunt = std::sqrt(std::max(-2.0 * std::log(std::min(strength, 1.0)), 1e-6));
  // Noise weakens higher frequencies more, which draws the top of the line down.
  const double drawn = std::pow(blunt / (2.0 * std::numbers::pi * line * deviation), 2);
  levels.step = 1.0 / (line * (1.0 + drawn));
  levels.step_sigma = levels.step * levels.step * blunt /
                      (2.0 * std::numbers::pi * deviation * std::sqrt(double(grey.size())));
  const double phase = std::arg(at(line)) / (2.0 * std::numbers::pi) * levels.step;
  const auto tooth = [&](double value) { return std::round((value - phase) / levels.step); };
  const bool noisy = blunt > 2.0 * std::numbers::pi * exact;
  const std::vector<float> all(grey.begin(), grey.end());
  const double top = noisy ? quantile(all, 1.0 - tail) : high;
  const double bottom = noisy ? quantile(all, tail) : low;
  // Teeth that stand on multiples of the step have not been moved: the lowest possible one is 0.
  const bool unmoved = std::abs(phase) < exact * levels.step;
  const double last = unmoved ? tooth(top) : tooth(top) - tooth(bottom);
  if (unmoved && tooth(bottom) <= 0.0) {
    levels.highest = levels.step * last;
    levels.highest_sigma = 0.5 * levels.step;
    return levels;
  }
  const double places = block_places / std::pow(2.0, folds);
  const double by_spread =
      2.0 * std::sqrt(2.0 * std::log(std::max(places, 2.0))) * moments.deviation;
  const double by_symmetry = 2.0 * moments.mean + levels.step;  // the floor takes half a step
  const double expected = unmoved ? 0.5 * (by_spread + by_symmetry) : by_spread;
  levels.highest = levels.step * std::max(last, std::round(expected / levels.step));
  levels.highest_sigma = std::max(levels.step, extreme_scatter * levels.highest);
  return levels;
}

}  // namespace hada
