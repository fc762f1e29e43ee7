#include "fit/profile.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "fit/solve.h"

namespace hada {
namespace {

constexpr double close_enough = 0.02;
constexpr int most_steps = 16;
const SolveOptions while_profiled{.max_iterations = 40, .tolerance = 1e-7};

/// `evaluate` with one field held at `value`: what the solver does to it changes nothing.
ResidualFunction held_at(const ResidualFunction& evaluate, std::size_t size, int field,
                         double value, int residual_count) {
  return [=](const double* packed, double* residuals, double* jacobian) {
    std::vector<double> at(packed, packed + size);
    at[std::size_t(field)] = value;
    evaluate(at.data(), residuals, jacobian);
    if (!jacobian) return;
    for (int i = 0; i < residual_count; ++i) jacobian[std::size_t(i) * size + field] = 0.0;
  };
}

/// How the deviance rises as one field moves away from its best.
class Profile {
 public:
  Profile(const std::vector<double>& packed, int field, const std::vector<SolverBounds>& bounds,
          int residual_count, const ResidualsWhileHeld& residuals, const WhileHeld& while_held)
      : best_(packed),
        field_(field),
        bounds_(bounds),
        residual_count_(residual_count),
        residuals_(residuals),
        while_held_(while_held),
        least_cost_(cost_at(packed[std::size_t(field)], best_)) {}

  /// Where the deviance has risen by the square of `wanted`.
  double end(double step, double wanted) {
    const double middle = best_[std::size_t(field_)];
    const auto [low, high] = bounds_[std::size_t(field_)];
    const double bound = step < 0.0 ? low : high;
    if (!std::isfinite(least_cost_)) return bound;
    auto from = best_;  // each descent starts where the last one ended
    double inside = middle, below = 0.0, outside = bound, above = HUGE_VAL;
    bool bracketed = false;
    double value = middle + wanted * step;
    for (int k = 0; k < most_steps; ++k) {
      value = std::clamp(value, low, high);
      const double rise = std::sqrt(2.0 * std::max(cost_at(value, from) - least_cost_, 0.0));
      if (std::abs(rise - wanted) < close_enough) break;
      if (rise < wanted) {
        if (value == bound) break;
        inside = value;
        below = rise;
      } else {
        outside = value;
        above = rise;
        bracketed = true;
      }
      if (bracketed) {  // half way where nothing is finite any more
        const double share = (wanted - below) / (above - below);
        value = inside +
                (std::isfinite(above) ? std::clamp(share, 0.1, 0.9) : 0.5) * (outside - inside);
      } else {
        value = middle + std::clamp(wanted / std::max(rise, 1e-3), 1.3, 3.0) * (value - middle);
      }
    }
    return std::clamp(value, low, high);
  }

 private:
  // from  where the descent starts, and then where it ended
  double cost_at(double value, std::vector<double>& from) const {
    auto bounds = bounds_;
    if (while_held_) while_held_(value, bounds);
    Ending ending;
    try {
      ending = descend({from}, bounds, residual_count_,
                       held_at(residuals_(value), from.size(), field_, value, residual_count_),
                       while_profiled)
                   .front();
    } catch (const Error&) {
      return HUGE_VAL;  // so far out that nothing is finite
    }
    from = ending.packed;
    return ending.cost;
  }

  std::vector<double> best_;
  int field_;
  const std::vector<SolverBounds>& bounds_;
  int residual_count_;
  const ResidualsWhileHeld& residuals_;
  const WhileHeld& while_held_;
  double least_cost_;
};

}  // namespace

std::array<double, 2> profile_interval(const std::vector<double>& packed, int field, double spread,
                                       double rise, const std::vector<SolverBounds>& bounds,
                                       int residual_count, const ResidualsWhileHeld& residuals,
                                       const WhileHeld& while_held) {
  Profile profile(packed, field, bounds, residual_count, residuals, while_held);
  const double step = spread > 0.0 ? spread : 1.0;
  return {profile.end(-step, std::sqrt(rise)), profile.end(step, std::sqrt(rise))};
}

}  // namespace hada
