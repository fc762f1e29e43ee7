#include "fit/wrinkle_intervals.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "fit/profile.h"
#include "fit/sampling.h"
#include "fit/solve.h"
#include "fit/whittle.h"

namespace hada {
namespace {

// The ends of +-1.96 sigma and of its exponential differ by a twelfth of it, and what is long
// beside its map is known the less the longer it is.
constexpr double asymmetric = 0.08;  // sigma of a logarithm
// Times that the variance of a field may be what independent ordinates would leave of it: where a
// field is not known to a factor, its covariance is no measure.
constexpr double most_shared = 10.0;
constexpr double apart = 3.0;         // deviations between axes that are surely two
constexpr double faint_floor = 1e-3;  // share of the lowest density, where nothing is seen of it
constexpr double quarter_turn = 0.5 * std::numbers::pi;  // an angle may be anything

enum Part { amplitude, longer, shorter, angle, per_component };

/// Whether the axes of a component may be one.
bool is_round(const Fit<Wrinkle<>>& fit, int component) {
  const auto& one = fit.material.components[std::size_t(component)];
  const int l = per_component * component + longer, s = l - longer + shorter;
  const auto& covariance = fit.covariance;
  const double variance = covariance(l, l) + covariance(s, s) - 2.0 * covariance(l, s);
  return std::log(one.long_mm / one.short_mm) < apart * std::sqrt(std::max(variance, 0.0));
}

/// Those that did not end on a bound.
std::vector<bool> known_fields(const Fit<Wrinkle<>>& fit) {
  std::vector<bool> known;
  visit_fields(fit.material, [&](const std::string& path, const auto&, double) {
    known.push_back(std::find(fit.on_bound.begin(), fit.on_bound.end(), path) ==
                    fit.on_bound.end());
  });
  return known;
}

/// While one axis is held, the other keeps to its side of it.
WhileHeld keeping_order(int part, int index) {
  if (part == longer) {
    return [index](double value, std::vector<SolverBounds>& bounds) {
      double& high = bounds[std::size_t(index + 1)].high;
      high = std::min(high, value);
    };
  }
  if (part == shorter) {
    return [index](double value, std::vector<SolverBounds>& bounds) {
      double& low = bounds[std::size_t(index - 1)].low;
      low = std::max(low, value);
    };
  }
  return {};
}

double lowest_of(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}

/// The deviances on cells of its own.
ResidualFunction residuals_on(std::vector<Cell> cells, const Wrinkle<>& shape, double kappa) {
  const auto kept = std::make_shared<const std::vector<Cell>>(std::move(cells));
  const auto evaluate = evaluator(shape, int(kept->size()), deviances(*kept, kappa));
  return [kept, evaluate](const double* packed, double* residuals, double* jacobian) {
    evaluate(packed, residuals, jacobian);
  };
}

}  // namespace

std::vector<FieldInterval> intervals_near_bounds(const Fit<Wrinkle<>>& fit,
                                                 const std::vector<Cell>& cells,
                                                 const Spectrum& spectrum, const SlowWaves& slow,
                                                 const FaintCells& faint) {
  Grid<double> overlap;  // found when it is needed
  const auto best = pack(fit.material);
  const auto plain_bounds = solver_bounds_of(fit.material);
  const int floor = per_component * int(fit.material.components.size());  // no repeated noise here

  // The deviance of ordinates that know of each other rises faster than what they know.
  const auto jacobian = jacobian_of(fit.material, int(cells.size()),
                                    whitened_logarithms(cells, spectrum.independence));
  const Eigen::MatrixXd unaware = covariance_of(jacobian.transpose() * jacobian, known_fields(fit));

  std::vector<FieldInterval> intervals;
  int index = -1;
  visit_fields(fit.material, [&](const std::string& path, const auto& field, double) {
    ++index;
    if (index > floor) return;  // ridges have their own
    const bool on_bound =
        std::find(fit.on_bound.begin(), fit.on_bound.end(), path) != fit.on_bound.end();
    const double sigma = std::sqrt(fit.covariance(index, index));
    const int part = index == floor ? -1 : index % per_component;
    const bool round = part > amplitude && is_round(fit, index / per_component);
    const bool loose = part != angle && sigma > asymmetric;
    if (!on_bound && !round && !loose) return;

    auto packed = best;
    auto bounds = plain_bounds;
    double& middle = packed[std::size_t(index)];
    double step = std::min(sigma, 1.0);
    if (index == floor && on_bound) {  // along a logarithm, nothing could be seen from there
      middle = std::log(faint_floor * lowest_of(densities(fit.material, faint.cells)));
      step = 1.0;
    }
    if (part == angle) {
      bounds[std::size_t(index)] = {middle - quarter_turn, middle + quarter_turn};
      step = std::min(sigma, 0.25);
    }
    // What the window does to a wide component depends on how wide it is held; not so to the floor.
    if (index != floor && overlap.empty()) overlap = taper_overlap(spectrum.taper);
    const ResidualsWhileHeld residuals = [&](double held) {
      auto there = packed;
      there[std::size_t(index)] = held;
      if (index == floor && on_bound)
        return residuals_on(faint.cells, fit.material, faint.independence);
      if (index == floor) return residuals_on(cells, fit.material, spectrum.independence);
      const auto held_there = unpack(fit.material, there.data());
      return residuals_on(
          slow.levelled(corrected(cells, held_there, overlap, spectrum.extent), held_there),
          fit.material, spectrum.independence);
    };
    const double shared =
        unaware(index, index) > 0.0 ? fit.covariance(index, index) / unaware(index, index) : 1.0;
    const double rise = std::min(shared, most_shared) * (round ? rise_of_two : rise_of_one);
    const int count = int(index == floor && on_bound ? faint.cells.size() : cells.size());
    const auto [low, high] = profile_interval(packed, index, step, rise, bounds, count, residuals,
                                              keeping_order(part, index));
    if (part == angle) {
      intervals.push_back({path, low, high});
    } else {
      // What reaches down to the bound of a solver reaches down to what the field may be.
      const bool open = low <= bounds[std::size_t(index)].low || (index == floor && on_bound);
      intervals.push_back({path, open ? field.low : std::exp(low), std::exp(high)});
    }
  });
  return intervals;
}

}  // namespace hada
