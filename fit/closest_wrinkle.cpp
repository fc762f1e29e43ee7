#include "fit/closest_wrinkle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "fit/solve.h"
#include "fit/whittle.h"
#include "fit/wrinkle.h"
#include "fit/wrinkle_starts.h"

namespace hada {
namespace {

constexpr int most_components = 5;
constexpr int drawn_starts = 12;
constexpr double far_nepers = 2.0;  // 9 dB: a cell further away than that loses its say

/// How far the model is from each cell, by the logarithm.
auto log_distances(const std::vector<Cell>& cells, double independence) {
  return CellResiduals(cells, [independence](const Cell& cell, const auto& model) {
    using std::log;
    const double n = cell.count;
    return std::sqrt(independence * std::sqrt(n)) *
           softened(std::log(cell.power) + bias_of_log_mean(n) - log(model), far_nepers);
  });
}

/// A wrinkle of any size, shape and direction that the picture can show.
Wrinkle<> drawn(int components, const Observation& seen, Seed seed) {
  const Extent& extent = seen.spectrum.extent;
  double variance = 0.0, lowest = HUGE_VAL;
  for (const Cell& cell : seen.square) {
    variance += 2.0 * cell.power * cell.count / (extent.width() * extent.height());
    lowest = std::min(lowest, cell.power);
  }
  const double least = 0.2 * extent.pitch;
  const double most = 0.1 * std::min(extent.width(), extent.height());
  Wrinkle<> wrinkle{.components = {}, .floor_mm4 = lowest};
  for (int k = 0; k < components; ++k) {
    const double length = least * std::pow(most / least, uniform(seed, k, 0));
    const double stretch = std::exp(1.5 * uniform(seed, k, 1));
    wrinkle.components.push_back({.amplitude_mm = std::sqrt(variance / components),
                                  .long_mm = length * stretch,
                                  .short_mm = length / stretch,
                                  .angle_rad = std::numbers::pi * uniform(seed, k, 2)});
  }
  return within_bounds(wrinkle);
}

double information_criterion(const Ending& ending, double cells) {
  return cells * std::log(ending.cost) + double(ending.packed.size()) * std::log(cells);
}

}  // namespace

Fit<Wrinkle<>> closest_wrinkle(const Observation& seen, const Fit<Wrinkle<>>& first,
                               int components) {
  const auto& cells = seen.square;
  const int count = int(cells.size());
  const auto distances = log_distances(cells, seen.spectrum.independence);
  Fit<Wrinkle<>> fit = first;
  fit.intervals.clear();
  Ending best;
  const int fewest = int(first.material.components.size());
  for (int k = fewest; k <= (components > 0 ? components : most_components); ++k) {
    std::vector<Wrinkle<>> starts{
        k == fewest ? first.material
                    : with_one_more(fit.material, cells, densities(fit.material, cells))};
    for (int i = 0; i < drawn_starts; ++i) starts.push_back(drawn(k, seen, Seed(i)));
    const auto endings =
        endings_of(starts, count, distances, {.max_iterations = 100, .tolerance = 1e-6});
    const auto ending =
        std::min_element(endings.begin(), endings.end(),
                         [](const Ending& a, const Ending& b) { return a.cost < b.cost; });
    if (k > fewest && information_criterion(*ending, count) >= information_criterion(best, count))
      break;
    best = *ending;
    fit.material = unpack(starts.front(), best.packed.data());
    fit.cost = best.cost;
    fit.starts = int(starts.size());
    fit.agreeing = 0;
    fit.runner_up_gap = HUGE_VAL;
    for (const Ending& other : endings) {
      if (other.cost < 1.01 * best.cost) {
        ++fit.agreeing;
      } else {
        fit.runner_up_gap = std::min(fit.runner_up_gap, other.cost - best.cost);
      }
    }
  }
  fit.material = canonical(fit.material);
  const auto jacobian = jacobian_of(fit.material, count, distances);
  const double misfit = 2.0 * fit.cost / std::max(count - int(best.packed.size()), 1);
  set_uncertainty(fit, jacobian.transpose() * jacobian / std::max(misfit, 1.0));
  return fit;
}

}  // namespace hada
