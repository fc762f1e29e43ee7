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
constexpr double settled = 1e-3;     // change of logarithms and angles that a correction may make
constexpr double most_worse = 1.2;   // than before may a refined fit explain the first cells
constexpr int fewest_per_field = 5;  // cells, so that a refinement has something to go by

double half_sum_of_squares(const Wrinkle<>& wrinkle, std::size_t count, const auto& residual) {
  std::vector<double> r(count);
  residual(wrinkle, r.data());
  double sum = 0.0;
  for (const double value : r) sum += 0.5 * value * value;
  return sum;
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

std::vector<Cell> refine(Fit<Wrinkle<>>& fit, const Observation& seen, const SlowWaves& slow) {
  const double kappa = seen.spectrum.independence;
  const Extent& extent = seen.spectrum.extent;
  const auto overlap = taper_overlap(seen.spectrum.taper);
  const int fields = spectral_fields(fit.material);
  const double first_cost = fit.cost;
  auto cells = seen.fine;
  for (int k = 0; k < most_corrections; ++k) {
    auto better_cells =
        trusted(slow.levelled(corrected(seen.full, fit.material, overlap, extent), fit.material),
                fit.material, extent.pitch);
    if (int(better_cells.size()) < fewest_per_field * fields) break;
    const auto better =
        solve(std::vector{fit.material}, int(better_cells.size()), deviances(better_cells, kappa),
              {.max_iterations = 60, .tolerance = 1e-8});
    // A model must not leave out the cells that speak against it.
    const auto first = deviances(seen.fine, kappa);
    if (half_sum_of_squares(better.material, seen.fine.size(), first) > most_worse * first_cost)
      break;
    cells = std::move(better_cells);
    const double moved = change(fit.material, better.material);
    fit.material = canonical(better.material);
    fit.cost = better.cost;
    if (moved < settled) break;
  }
  // A floor that the data cannot tell from none is none.
  Wrinkle<> bare = fit.material;
  bare.floor_mm4 = 0.0;
  const double without = half_sum_of_squares(bare, cells.size(), deviances(cells, kappa));
  if (without < fit.cost + 0.01) fit.material = bare;

  const auto jacobian =
      jacobian_of(fit.material, int(cells.size()), whitened_logarithms(cells, kappa));
  set_uncertainty(fit, slow.information(cells, fit.material, jacobian, kappa));
  fit.goodness_p = goodness_of_fit(cells, densities(fit.material, cells), kappa, fields);
  return cells;
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
  auto cells = refine(best, seen, slow);
  for (; !all_told(best) && !fewer.empty(); fewer.pop_back()) {
    best = std::move(fewer.back());
    cells = refine(best, seen, slow);
  }
  best.intervals = intervals_near_bounds(best, cells, seen.spectrum, slow);
  return best;
}

}  // namespace hada
