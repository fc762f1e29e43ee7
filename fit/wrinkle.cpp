#include "fit/wrinkle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fit/closest_wrinkle.h"
#include "fit/goodness.h"
#include "fit/observe.h"
#include "fit/ridge_sheets.h"
#include "fit/solve.h"
#include "fit/unit_map.h"
#include "fit/whittle.h"
#include "fit/wrinkle_refine.h"
#include "fit/wrinkle_starts.h"
#include "measure/measured_map.h"
#include "measure/plane_share.h"

namespace hada {
namespace {

constexpr double widest_share = 1.0 / 7.0;  // of the map, whose length its spectrum can tell
constexpr double least_goodness = 1e-3;     // p below which a person is told
constexpr double hopeless = 1e-12;          // p below which no refinement makes a picture wrinkles
// p of the whole spectrum below which a picture is no wrinkles either: 18 pictures of wrinkles, of
// 8 and 16 bits and of floats, had 0.005 or more, 6 pieces of wood and fabric 2e-15 or less.
constexpr double no_wrinkles = 1e-6;
constexpr double same_rough_cost = 0.5;  // of starts that are on the way to the same place
constexpr double same_share = 0.02;      // by which the fields of one and the same end may differ
constexpr int most_groups = 4;           // of starts that are worth the whole spectrum
constexpr double visible_floor = 0.3;    // share of the lowest power

/// A wrinkle that explains as many components one after the other, each where most is left over.
Wrinkle<> grown(int components, const Observation& seen) {
  auto wrinkle = wrinkle_starts(seen.spectrum, 1, 1).front();
  const auto residual = log_ratios(seen.coarse, seen.of_starts().independence);
  while (int(wrinkle.components.size()) < components) {
    const auto ending = endings_of(std::vector{wrinkle}, int(seen.coarse.size()), residual,
                                   {.max_iterations = 30, .tolerance = 1e-3})
                            .front();
    wrinkle = unpack(wrinkle, ending.packed.data());
    wrinkle = with_one_more(wrinkle, seen.coarse, densities(wrinkle, seen.coarse));
  }
  return wrinkle;
}

double lowest_power(const std::vector<Cell>& cells) {
  const auto fainter = [](const Cell& a, const Cell& b) { return a.power < b.power; };
  return std::min_element(cells.begin(), cells.end(), fainter)->power;
}

/// Long >= short, the longest first.
template <class Noise>
void put_in_order(std::vector<Noise>& functions) {
  for (Noise& noise : functions) {
    if (noise.long_mm >= noise.short_mm) continue;
    std::swap(noise.long_mm, noise.short_mm);
    noise.angle_rad += 0.5 * std::numbers::pi;
  }
  std::stable_sort(functions.begin(), functions.end(),
                   [](const Noise& a, const Noise& b) { return a.long_mm > b.long_mm; });
}

/// Whether two canonical wrinkles, of plain components, are one; how far below everything their
/// floors lie is no matter.
bool alike(const Wrinkle<>& a, const Wrinkle<>& b) {
  for (std::size_t k = 0; k < a.components.size(); ++k) {
    const auto &one = a.components[k], &other = b.components[k];
    const auto differ = [](double x, double y) { return std::abs(std::log(x / y)) > same_share; };
    if (differ(one.amplitude_mm, other.amplitude_mm) || differ(one.long_mm, other.long_mm) ||
        differ(one.short_mm, other.short_mm))
      return false;
  }
  return true;
}

/// Starts that ended at the same place.
struct Group {
  Wrinkle<> material;
  double cost;
  int starts;
};

/// Groups of equal cost, the best first.
std::vector<Group> groups_of(const Wrinkle<>& shape, std::vector<Ending> endings, double same) {
  std::stable_sort(endings.begin(), endings.end(),
                   [](const Ending& a, const Ending& b) { return a.cost < b.cost; });
  std::vector<Group> groups;
  for (const Ending& ending : endings) {
    if (!std::isfinite(ending.cost)) break;
    if (groups.empty() || ending.cost > groups.back().cost + same)
      groups.push_back({unpack(shape, ending.packed.data()), ending.cost, 0});
    ++groups.back().starts;
  }
  return groups;
}

/// The spectrum says nothing of ridges.
void forget_ridges(Fit<Wrinkle<>>& fit) {
  fit.covariance.bottomRows(ridge_fields).setZero();
  fit.covariance.rightCols(ridge_fields).setZero();
  fit.sigma = with(std::move(fit.sigma), Ridges::Zero());
}

/// What the map itself tells of them.
RidgeEvidence add_ridges(Fit<Wrinkle<>>& fit, const Surface& surface, const FitProgress& progress) {
  const auto map = measured_map(surface);
  const RidgeFit ridges = fit_ridges(map, surface.mask, fit, surface.extent, progress);
  fit.covariance.bottomRightCorner(ridge_fields, ridge_fields) = ridges.covariance;
  fit.material = with(std::move(fit.material), ridges.value);
  fit.sigma = with(std::move(fit.sigma), ridges.sigma);
  fit.remarks.push_back(told(ridges));
  return ridges.evidence;
}

/// The best of several starts, over the cells that aliases cannot reach.
Fit<Wrinkle<>> fit_from(const std::vector<Wrinkle<>>& starts, const Observation& seen) {
  const double kappa = seen.of_starts().independence;
  const auto& shape = starts.front();
  auto rough = groups_of(shape,
                         endings_of(starts, int(seen.coarse.size()), log_ratios(seen.coarse, kappa),
                                    {.max_iterations = 50, .tolerance = 1e-4}),
                         same_rough_cost);
  if (int(rough.size()) > most_groups) rough.resize(most_groups);
  std::vector<Wrinkle<>> promising;
  for (const Group& group : rough) {
    promising.push_back(group.material);
    // The logarithm of a floor that nothing sees has no slope to climb back along.
    double& floor = promising.back().floor_mm4;
    floor = std::max(floor, visible_floor * lowest_power(seen.fine));
  }
  const auto endings = endings_of(promising, int(seen.fine.size()), deviances(seen.fine, kappa),
                                  {.max_iterations = 40, .tolerance = 1e-6});

  const auto best =
      std::min_element(endings.begin(), endings.end(),
                       [](const Ending& a, const Ending& b) { return a.cost < b.cost; });
  Fit<Wrinkle<>> fit;
  fit.material = canonical(unpack(shape, best->packed.data()));
  fit.cost = best->cost;
  fit.starts = int(starts.size());
  fit.runner_up_gap = HUGE_VAL;
  for (std::size_t k = 0; k < endings.size(); ++k) {
    if (alike(canonical(unpack(shape, endings[k].packed.data())), fit.material)) {
      fit.agreeing += rough[k].starts;
    } else {
      fit.runner_up_gap = std::min(fit.runner_up_gap, endings[k].cost - fit.cost);
    }
  }
  return fit;
}

std::vector<std::string> remarks_on(const Fit<Wrinkle<>>& fit, const Extent& extent) {
  std::vector<std::string> remarks;
  const auto& longest = fit.material.components.front();
  if (longest.long_mm > widest_share * std::min(extent.width(), extent.height())) {
    remarks.push_back(
        "The longest wrinkles reach across the map: read the sigma and the interval of their "
        "length as too small.");
  }
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
  return 2.0 * fit.cost + double(spectral_fields(fit.material)) *
                              std::log(seen.of_starts().independence * ordinates);
}

}  // namespace

Wrinkle<> canonical(Wrinkle<> wrinkle) {
  put_in_order(wrinkle.components);
  put_in_order(wrinkle.repeated);
  put_in_order(wrinkle.woven);
  return wrapped(wrinkle);
}

WrinkleFit fit_wrinkle(const Surface& surface, const WrinkleFitOptions& options) {
  const MapUnits units = units_of(surface);
  const Observation seen = observe(in_units(surface, units), options.lens_blur_px);
  const StartCells exact(seen);
  const int starts = std::max(options.starts, 6);
  const int fewest = options.components > 0 ? options.components : 1;
  const int most = options.components > 0 ? options.components : options.most_components;
  Fit<Wrinkle<>> best;
  std::vector<Fit<Wrinkle<>>> fewer;  // the best of each smaller number of components
  const auto tell = [&](const std::string& stage) {
    if (options.progress) options.progress(stage);
  };
  for (int components = fewest; components <= most; ++components) {
    tell(std::to_string(components) + (components == 1 ? " component, " : " components, ") +
         std::to_string(starts) + " starts");
    auto from = wrinkle_starts(seen.spectrum, components, starts - 1);
    from.push_back(components == fewest ? grown(components, seen)
                                        : with_one_more(best.material, seen.fine,
                                                        densities(best.material, seen.fine)));
    auto fit = fit_from(from, seen);
    exact.settle(fit);
    if (components > fewest) {
      if (bic(fit, seen) >= bic(best, seen)) break;
      fewer.push_back(std::move(best));
    }
    best = std::move(fit);
  }
  const bool picture = !surface.has_height();
  const auto goodness = [&](const std::vector<Cell>& cells, const Spectrum& spectrum) {
    return goodness_of_fit(cells, densities(best.material, cells), spectrum.independence,
                           spectral_fields(best.material));
  };
  best.goodness_p = goodness(seen.fine, seen.of_starts());
  if (!picture || best.goodness_p > hopeless) {
    tell("refining " + std::to_string(best.material.components.size()) +
         " over the whole spectrum");
    best = refined_and_told(std::move(best), std::move(fewer), seen);
    // The coarse spectrum of a small piece passes for wrinkles easily.
    const double whole = picture ? goodness(seen.whole, seen.spectrum) : 1.0;
    if (whole < no_wrinkles) best.goodness_p = whole;
  }
  if (picture && best.goodness_p < least_goodness) {
    const double goodness_p = best.goodness_p;
    best = closest_wrinkle(seen, options.components, options.progress);
    best.goodness_p = goodness_p;
  }
  best.remarks = seen.remarks;
  if (!picture && plane_share(surface.height, surface.mask) > much_plane) {
    best.remarks.push_back(
        "Most of the height is a plane, which was fitted as long wrinkles: take it off first.");
  }
  for (auto& remark : remarks_on(best, seen.spectrum.extent))
    best.remarks.push_back(std::move(remark));
  give_back_units(best, units);
  forget_ridges(best);
  RidgeEvidence ridges;
  if (options.ridges) ridges = add_ridges(best, surface, options.progress);
  return {std::move(best), ridges};
}

}  // namespace hada
