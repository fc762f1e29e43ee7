#include "fit/wrinkle_refine.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/goodness.h"
#include "fit/sampling.h"
#include "fit/solve.h"
#include "fit/whittle.h"
#include "fit/wrinkle.h"
#include "fit/wrinkle_intervals.h"

namespace hada {
namespace {

// Of the window, which each wants for the wrinkle before. The wider a component beside the map, the
// slower they settle: two leave half a sigma of bias where it is a twentieth as wide.
constexpr int most_corrections = 12;
constexpr double settled = 1e-3;    // change of logarithms and angles that a correction may make
constexpr int most_astray = 3;      // refined fits in a row that explain the first cells worse
constexpr double most_worse = 1.2;  // than before may a refined fit explain the first cells
constexpr double no_dearer = 0.01;  // cost that a floor must save to be told from none
constexpr double surely_dearer = 15.0;  // cost without a floor that is surely there
constexpr int fewest_per_field = 5;     // cells, so that a refinement has something to go by

double half_sum_of_squares(const Wrinkle<>& wrinkle, std::size_t count, const auto& residual) {
  std::vector<double> r(count);
  residual(wrinkle, r.data());
  double sum = 0.0;
  for (const double value : r) sum += 0.5 * value * value;
  return sum;
}

Wrinkle<> without_floor(Wrinkle<> wrinkle) {
  wrinkle.floor_mm4 = 0.0;
  return wrinkle;
}

/// The largest change of an amplitude, a length or an angle.
double change(const Wrinkle<>& before, const Wrinkle<>& after) {
  const auto a = pack(before), b = pack(after);
  double largest = 0.0;
  for (int k = 0; k + 1 < spectral_fields(before); ++k)  // all but the floor, which may be none
    largest = std::max(largest, std::abs(a[std::size_t(k)] - b[std::size_t(k)]));
  return largest;
}

}  // namespace

int spectral_fields(const Wrinkle<>& wrinkle) {
  return int(pack(wrinkle).size()) - ridge_fields;
}

StartCells::StartCells(const Observation& seen)
    : seen_(seen), overlap_(taper_overlap(seen.of_starts().taper)) {}

std::vector<Cell> StartCells::exact_for(const Wrinkle<>& wrinkle) const {
  return corrected(seen_.fine, wrinkle, overlap_, seen_.spectrum.extent);
}

double StartCells::cost(const Wrinkle<>& wrinkle) const {
  const auto cells = exact_for(wrinkle);
  return half_sum_of_squares(wrinkle, cells.size(),
                             deviances(cells, seen_.of_starts().independence));
}

bool StartCells::tell_floor(const Wrinkle<>& wrinkle, double cost_with) const {
  return wrinkle.floor_mm4 > 0.0 && cost(without_floor(wrinkle)) > cost_with + surely_dearer;
}

void StartCells::settle(Fit<Wrinkle<>>& fit) const {
  constexpr int rounds = 2;
  fit.cost = cost(fit.material);
  const auto take = [&](const Wrinkle<>& other, double may_cost_more) {
    const double there = cost(other);
    if (!(there < fit.cost + may_cost_more)) return false;
    fit.material = canonical(other);
    fit.cost = there;
    return true;
  };
  for (int k = 0; k < rounds; ++k) {
    const auto cells = exact_for(fit.material);
    const auto better = solve(std::vector{fit.material}, int(cells.size()),
                              deviances(cells, seen_.of_starts().independence),
                              {.max_iterations = 40, .tolerance = 1e-6});
    if (!take(better.material, 0.0)) break;
  }
  take(without_floor(fit.material), no_dearer);
}

RefinedCells refine(Fit<Wrinkle<>>& fit, const Observation& seen, const SlowWaves& slow) {
  const Extent& extent = seen.spectrum.extent;
  const auto overlap = taper_overlap(seen.spectrum.taper);
  const int fields = spectral_fields(fit.material);
  const StartCells first(seen);
  const double first_cost = first.cost(fit.material);
  RefinedCells found{first.exact_for(fit.material), &seen.of_starts()};
  Wrinkle<> at = fit.material;
  double cost = first_cost;
  bool floor_told = false;
  int astray = 0;
  for (int k = 0; k < most_corrections && astray < most_astray; ++k) {
    // By a floor that is none, cells would be trusted that hold leakage alone.
    floor_told = floor_told || first.tell_floor(at, cost);
    if (!floor_told) at.floor_mm4 = 0.0;
    auto cells = trusted(slow.levelled(corrected(seen.full, at, overlap, extent), at), at, extent);
    if (int(cells.size()) < fewest_per_field * fields) break;
    const auto better =
        solve(std::vector{at}, int(cells.size()), deviances(cells, seen.spectrum.independence),
              {.max_iterations = 60, .tolerance = 1e-8});
    const double moved = change(at, better.material);
    at = canonical(better.material);
    // A model must not leave out the cells that speak against it; the next may bring it back.
    cost = first.cost(at);
    const bool strays = cost > most_worse * first_cost;
    astray = strays ? astray + 1 : 0;
    if (strays) continue;
    found = {std::move(cells), &seen.spectrum};
    fit.material = at;
    fit.cost = better.cost;
    if (moved < settled) break;
  }
  const auto& cells = found.cells;
  const double kappa = found.spectrum->independence;
  // A floor that the data cannot tell from none is none.
  const Wrinkle<> bare = without_floor(fit.material);
  const double without = half_sum_of_squares(bare, cells.size(), deviances(cells, kappa));
  if (without < fit.cost + no_dearer) fit.material = bare;

  const auto jacobian =
      jacobian_of(fit.material, int(cells.size()), whitened_logarithms(cells, kappa));
  set_uncertainty(fit, slow.information(cells, fit.material, jacobian, kappa));
  fit.goodness_p = goodness_of_fit(cells, densities(fit.material, cells), kappa, fields);
  return found;
}

bool all_told(const Fit<Wrinkle<>>& fit) {
  for (std::size_t k = 0; k < fit.material.components.size(); ++k) {
    if (!(fit.sigma.components[k].amplitude_mm < fit.material.components[k].amplitude_mm))
      return false;
  }
  return true;
}

Fit<Wrinkle<>> refined_and_told(Fit<Wrinkle<>> best, std::vector<Fit<Wrinkle<>>> fewer,
                                const Observation& seen) {
  const SlowWaves slow(seen.spectrum, seen.levelling);
  auto refined = refine(best, seen, slow);
  for (; !all_told(best) && !fewer.empty(); fewer.pop_back()) {
    best = std::move(fewer.back());
    refined = refine(best, seen, slow);
  }
  const FaintCells faint =
      seen.steep ? FaintCells{StartCells(seen).exact_for(best.material), seen.steep->independence}
                 : FaintCells{refined.cells, refined.spectrum->independence};
  best.intervals = intervals_near_bounds(best, refined.cells, *refined.spectrum, slow, faint);
  return best;
}

}  // namespace hada
