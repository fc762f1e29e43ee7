#include "fit/classify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Core>
#include <Eigen/LU>

#include "fit/goodness.h"
#include "fit/observe.h"
#include "fit/solve.h"
#include "fit/whittle.h"

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int turns = 6;      // starts, over half a turn
constexpr int nuisances = 4;  // amplitude, length, turn, floor
constexpr double derivative_step = 1e-5;
constexpr double most_spreads = 4.0;  // from the kind, in deviations, that a sheet may lie

/// How a sheet differs from its kind, as the solver sees it.
struct Variation {
  double log_amplitude, log_length, turn_rad, log_floor;

  static Variation from(const double* packed) {
    return {packed[0], packed[1], packed[2], packed[3]};
  }
};

Wrinkle<> varied(Wrinkle<> kind, const Variation& by) {
  for (auto& component : kind.components) {
    component.amplitude_mm *= std::exp(by.log_amplitude);
    component.long_mm *= std::exp(by.log_length);
    component.short_mm *= std::exp(by.log_length);
    component.angle_rad += by.turn_rad;
  }
  for (auto& noise : kind.repeated) {
    noise.amplitude_mm *= std::exp(by.log_amplitude);
    for (double* length : {&noise.long_mm, &noise.short_mm, &noise.period_mm})
      *length *= std::exp(by.log_length);
    noise.angle_rad += by.turn_rad;
    noise.period_angle_rad += by.turn_rad;
  }
  for (auto& noise : kind.woven) {
    noise.amplitude_mm *= std::exp(by.log_amplitude);
    for (double* length :
         {&noise.long_mm, &noise.short_mm, &noise.period_mm, &noise.other_period_mm})
      *length *= std::exp(by.log_length);
    for (double* angle : {&noise.angle_rad, &noise.period_angle_rad, &noise.other_period_angle_rad})
      *angle += by.turn_rad;
  }
  kind.floor_mm4 += std::exp(by.log_floor);
  return kind;
}

/// The residuals of the cells, then those of what is believed of sheets of one kind.
ResidualFunction residuals_of(const Wrinkle<>& kind, const std::vector<Cell>& cells, double kappa,
                              const ClassifyOptions& options) {
  const auto deviance = deviances(cells, kappa);
  const int count = int(cells.size()) + 2;
  const auto values = [=](const double* packed, double* residuals) {
    const Variation by = Variation::from(packed);
    deviance(varied(kind, by), residuals);
    residuals[count - 2] = by.log_amplitude / options.amplitude_spread;
    residuals[count - 1] = by.log_length / options.length_spread;
  };
  return [=](const double* packed, double* residuals, double* jacobian) {
    values(packed, residuals);
    if (!jacobian) return;
    std::vector<double> above(std::size_t(count), 0.0), below(above);
    for (int k = 0; k < nuisances; ++k) {
      std::array<double, nuisances> moved;
      std::copy_n(packed, nuisances, moved.begin());
      moved[std::size_t(k)] += derivative_step;
      values(moved.data(), above.data());
      moved[std::size_t(k)] -= 2.0 * derivative_step;
      values(moved.data(), below.data());
      for (int i = 0; i < count; ++i) {
        jacobian[i * nuisances + k] =
            (above[std::size_t(i)] - below[std::size_t(i)]) / (2.0 * derivative_step);
      }
    }
  };
}

/// Where one kind explains the sheet best.
struct Explanation {
  std::vector<double> packed;
  double cost;
  double log_information;  // of the nuisances
};

Explanation best_explanation(const Wrinkle<>& kind, const std::vector<Cell>& cells, double kappa,
                             const ClassifyOptions& options) {
  double lowest = HUGE_VAL;
  for (const Cell& cell : cells) lowest = std::min(lowest, cell.power);
  std::vector<std::vector<double>> starts;
  for (int k = 0; k < turns; ++k) {
    starts.push_back({0.0, 0.0, pi * k / turns, std::log(0.3 * lowest)});
  }
  const std::vector<SolverBounds> bounds{
      {-most_spreads * options.amplitude_spread, most_spreads * options.amplitude_spread},
      {-most_spreads * options.length_spread, most_spreads * options.length_spread},
      {-HUGE_VAL, HUGE_VAL},
      {std::log(1e-12 * lowest), std::log(1e12 * lowest)}};
  const int count = int(cells.size()) + 2;
  const auto residuals = residuals_of(kind, cells, kappa, options);
  const auto endings =
      descend(starts, bounds, count, residuals, {.max_iterations = 40, .tolerance = 1e-6});
  const auto best =
      *std::min_element(endings.begin(), endings.end(),
                        [](const Ending& a, const Ending& b) { return a.cost < b.cost; });
  Eigen::Matrix<double, Eigen::Dynamic, nuisances, Eigen::RowMajor> jacobian(count, nuisances);
  std::vector<double> values(std::size_t(count), 0.0);
  residuals(best.packed.data(), values.data(), jacobian.data());
  Eigen::Matrix4d information = jacobian.transpose() * jacobian;
  // A turn and a floor that the data do not see are known to a radian and to a factor e.
  information(2, 2) += 1.0;
  information(3, 3) += 1.0;
  return {best.packed, best.cost, std::log(information.determinant())};
}

}  // namespace

std::vector<Likeness> classify(const Surface& surface, const std::vector<Wrinkle<>>& kinds,
                               const ClassifyOptions& options) {
  const Observation seen = observe(surface);
  const double kappa = seen.of_starts().independence;
  std::vector<Explanation> explanations;
  for (const Wrinkle<>& kind : kinds) {
    explanations.push_back(best_explanation(kind, seen.coarse, kappa, options));
  }
  double least_cost = HUGE_VAL;
  for (const auto& one : explanations) least_cost = std::min(least_cost, one.cost);
  // Where no kind is quite right, cells disagree with all of them by more than chance, and no
  // difference between kinds may count for more than it would among such disagreements.
  const double temper = std::max(1.0, 2.0 * least_cost / double(seen.coarse.size()));

  std::vector<Likeness> likenesses;
  double sum = 0.0;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    const auto& [packed, cost, log_information] = explanations[k];
    const Variation by = Variation::from(packed.data());
    Likeness likeness;
    likeness.probability = std::exp(-(cost - least_cost) / temper -
                                    0.5 * (log_information - explanations.front().log_information));
    likeness.amplitude = std::exp(by.log_amplitude);
    likeness.length = std::exp(by.log_length);
    likeness.turn_rad = std::remainder(by.turn_rad, pi);
    likeness.goodness_p =
        goodness_of_fit(seen.fine, densities(varied(kinds[k], by), seen.fine), kappa, nuisances);
    sum += likeness.probability;
    likenesses.push_back(likeness);
  }
  for (Likeness& likeness : likenesses) likeness.probability /= sum;
  return likenesses;
}

}  // namespace hada
