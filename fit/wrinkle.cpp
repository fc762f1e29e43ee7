#include "fit/wrinkle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "fit/cells.h"
#include "fit/goodness.h"
#include "fit/sampling.h"
#include "fit/solve.h"
#include "fit/whittle.h"
#include "fit/wrinkle_starts.h"

namespace hada {
namespace {

constexpr int fewest_pixels = 32;  // along each side: fewer hold too few ordinates to tell shapes
constexpr double least_goodness = 1e-3;  // p below which a person is told
constexpr double safe_reach = 0.7;   // share of Nyquist up to which aliases of anything are small
constexpr int corrections = 2;       // of the window: each leaves a small share of the error before
constexpr int fewest_per_field = 5;  // cells, so that a refinement has something to go by

/// What the fit looks at.
struct Observation {
  Spectrum spectrum;
  std::vector<Cell> coarse;
  std::vector<Cell> fine;  // to where aliases may begin
  std::vector<Cell> full;  // to the Nyquist frequency
  std::vector<std::string> remarks;
};

/// Taking off the mean empties frequency 0 alone. A plane takes 6 / pi^2 of the power one step away
/// with it; a quadratic nearly all of that, and some of it two steps away.
double steps_emptied_by(const std::string& levelling) {
  if (levelling == "offset") return 0.5;
  return levelling == "plane" ? 1.5 : 2.5;
}

Observation observe(const Surface& surface) {
  Observation seen;
  if (!surface.has_height() && surface.albedo.empty()) {
    throw Error("wrinkle fit: the surface has neither height nor albedo; reconstruct it first");
  }
  if (!surface.has_height()) {
    seen.remarks.push_back(
        "The surface has no height, so the wrinkles describe its brightness: amplitudes are "
        "brightness, not lengths.");
  }
  const auto map = surface.has_height() ? surface.height : luminance(surface.albedo);
  seen.spectrum = power_spectrum(map, surface.mask, surface.extent);
  const Extent& box = seen.spectrum.extent;
  if (box.rows < fewest_pixels || box.cols < fewest_pixels) {
    throw Error("wrinkle fit: the mask is smaller than 32 x 32 pixels; measure a larger sample");
  }
  if (surface.extent.unit == Unit::px) {
    seen.remarks.push_back("The pitch is unknown: lengths and amplitudes count pixels, not mm.");
  }
  const Leakage leaked = leakage(seen.spectrum);
  const double hole = steps_emptied_by(surface.levelling);
  seen.full =
      cells_of(seen.spectrum, leaked, {.empty_steps = hole, .most_leakage = 1.0, .faintest = 0.0});
  seen.fine = cells_of(seen.spectrum, leaked, {.empty_steps = hole, .reach = safe_reach});
  seen.coarse = cells_of(seen.spectrum, leaked,
                         {.empty_steps = hole,
                          .reach = safe_reach,
                          .inner_bins = 10.0,
                          .growth = 0.12,
                          .faintest = 1e-6});
  double highest = 0.0;
  for (const Cell& cell : seen.fine) highest = std::max(highest, cell.power);
  if (!(highest > 0.0)) {
    throw Error("wrinkle fit: the map is flat; there is nothing to fit");
  }
  // A cell that is empty to rounding has no logarithm.
  for (auto* cells : {&seen.coarse, &seen.fine, &seen.full}) {
    for (Cell& cell : *cells) cell.power = std::max(cell.power, 1e-25 * highest);
  }
  return seen;
}

/// The same wrinkles as everyone would write them: long >= short, long components first.
Wrinkle<> canonical(Wrinkle<> wrinkle) {
  for (auto& component : wrinkle.components) {
    if (component.long_mm >= component.short_mm) continue;
    std::swap(component.long_mm, component.short_mm);
    component.angle_rad += 0.5 * std::numbers::pi;
  }
  std::stable_sort(wrinkle.components.begin(), wrinkle.components.end(),
                   [](const auto& a, const auto& b) { return a.long_mm > b.long_mm; });
  return wrapped(wrinkle);
}

double half_sum_of_squares(const Wrinkle<>& wrinkle, std::size_t count, const auto& residual) {
  std::vector<double> r(count);
  residual(wrinkle, r.data());
  double sum = 0.0;
  for (const double value : r) sum += 0.5 * value * value;
  return sum;
}

std::vector<Wrinkle<>> materials(const Wrinkle<>& shape, const std::vector<Ending>& endings) {
  std::vector<Wrinkle<>> result;
  for (const auto& ending : endings) {
    if (std::isfinite(ending.cost)) result.push_back(unpack(shape, ending.packed.data()));
  }
  return result;
}

/// The best of several starts, over the cells that aliases cannot reach.
Fit<Wrinkle<>> fit_from(const std::vector<Wrinkle<>>& starts, const Observation& seen) {
  const double kappa = seen.spectrum.independence;
  const auto rough = materials(
      starts.front(), endings_of(starts, int(seen.coarse.size()), log_ratios(seen.coarse, kappa),
                                 {.max_iterations = 50, .tolerance = 1e-4}));
  auto fit = solve(rough, int(seen.fine.size()), deviances(seen.fine, kappa),
                   {.max_iterations = 60, .tolerance = 1e-7});
  fit.starts = int(starts.size());
  fit.material = canonical(fit.material);
  return fit;
}

/// `fit` moved to where the whole spectrum and the exact window want it, and its uncertainty.
void refine(Fit<Wrinkle<>>& fit, const Observation& seen) {
  const double kappa = seen.spectrum.independence;
  const Extent& extent = seen.spectrum.extent;
  const auto overlap = taper_overlap(seen.spectrum.taper);
  const int fields = int(pack(fit.material).size());
  auto cells = seen.fine;
  for (int k = 0; k < corrections; ++k) {
    auto better_cells =
        trusted(corrected(seen.full, fit.material, overlap, extent), fit.material, extent.pitch);
    if (int(better_cells.size()) < fewest_per_field * fields) break;
    cells = std::move(better_cells);
    const auto better = solve(std::vector{fit.material}, int(cells.size()), deviances(cells, kappa),
                              {.max_iterations = 60, .tolerance = 1e-8});
    fit.material = canonical(better.material);
    fit.cost = better.cost;
  }
  // A floor that the data cannot tell from none is none.
  Wrinkle<> bare = fit.material;
  bare.floor_mm4 = 0.0;
  const double without = half_sum_of_squares(bare, cells.size(), deviances(cells, kappa));
  if (without < fit.cost + 0.01) fit.material = bare;

  const auto jacobian =
      jacobian_of(fit.material, int(cells.size()), whitened_logarithms(cells, kappa));
  set_uncertainty(fit, jacobian.transpose() * jacobian);
  fit.goodness_p = goodness_of_fit(cells, densities(fit.material, cells), kappa, fields);
}

std::vector<std::string> remarks_on(const Fit<Wrinkle<>>& fit) {
  std::vector<std::string> remarks;
  for (const auto& path : fit.on_bound) {
    remarks.push_back(path == "floor_mm4"
                          ? "No noise floor can be seen; floor_mm4 lies on its lower bound."
                          : path + " ended on a bound, so that its sigma means nothing.");
  }
  if (fit.agreeing < 2 && fit.starts > 1) {
    remarks.push_back("Only one start of " + std::to_string(fit.starts) +
                      " ended at the best fit; another fit may be as good.");
  }
  if (fit.goodness_p < least_goodness) {
    remarks.push_back(
        "The spectrum departs from that of wrinkle noise by more than chance explains: read the "
        "sigmas as too small.");
  }
  return remarks;
}

double bic(const Fit<Wrinkle<>>& fit, const Observation& seen) {
  double ordinates = 0.0;
  for (const Cell& cell : seen.fine) ordinates += cell.count;
  return 2.0 * fit.cost +
         double(pack(fit.material).size()) * std::log(seen.spectrum.independence * ordinates);
}

}  // namespace

Fit<Wrinkle<>> fit_wrinkle(const Surface& surface, const WrinkleFitOptions& options) {
  const Observation seen = observe(surface);
  const int starts = std::max(options.starts, 6);
  const int fewest = options.components > 0 ? options.components : 1;
  const int most = options.components > 0 ? options.components : options.most_components;
  Fit<Wrinkle<>> best;
  for (int components = fewest; components <= most; ++components) {
    auto from = wrinkle_starts(seen.spectrum, components, starts);
    if (components > fewest) {
      from.push_back(with_one_more(best.material, seen.fine, densities(best.material, seen.fine)));
    }
    auto fit = fit_from(from, seen);
    if (components > fewest && bic(fit, seen) >= bic(best, seen)) break;
    best = std::move(fit);
  }
  refine(best, seen);
  best.remarks = seen.remarks;
  for (auto& remark : remarks_on(best)) best.remarks.push_back(std::move(remark));
  return best;
}

}  // namespace hada
