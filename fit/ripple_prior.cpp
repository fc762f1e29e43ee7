#include "fit/ripple_prior.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

/// Spectral density at frequency 0 of Matern's covariance of order 3/2 in space, unit lengths.
const double matern = 32.0 * pi / std::sqrt(27.0);

/// Frequencies of a wave along x, y and z, radians for each unit of length.
Eigen::Vector3d frequency_of(const Ripples& ripples, std::size_t n) {
  Eigen::Vector3d frequency;
  for (std::size_t axis = 0; axis < 3; ++axis)
    frequency[Eigen::Index(axis)] = pi * ripples.orders()[n][axis] / ripples.box().sides[axis];
  return frequency;
}

/// Logarithm of the evidence, up to what all priors share.
double evidence(const GrowthSolid& solid, const SolidEquations& sums, const RipplePrior& prior,
                double noise) {
  const double trust = 1.0 / (noise * noise);
  Eigen::VectorXd precision = sums.precision;
  const auto sigma = wave_sigma(solid.ripples, prior);
  for (std::size_t n = 0; n < sigma.size(); ++n)
    precision[solid.ripples_at() + Eigen::Index(n)] = 1.0 / (sigma[n] * sigma[n]);
  Eigen::MatrixXd information = trust * sums.normal;
  information.diagonal() += precision;
  const Eigen::VectorXd right = precision.cwiseProduct(sums.mean) - trust * sums.right;
  const Eigen::LLT<Eigen::MatrixXd> root(information);
  const double volume = 2.0 * root.matrixLLT().diagonal().array().log().sum();
  const double misfit = trust * sums.squares + sums.mean.dot(precision.cwiseProduct(sums.mean)) -
                        right.dot(root.solve(right));
  return -0.5 * misfit + 0.5 * precision.array().log().sum() - 0.5 * volume -
         sums.count * std::log(noise);
}

/// A prior, the noise beside what it was taken for, and their evidence.
struct Climbed {
  RipplePrior prior;
  double noise = 1.0;
  double evidence = -HUGE_VAL;
};

Climbed climbed(const GrowthSolid& solid, const SolidEquations& equations, const RipplePrior& from,
                double highest) {
  constexpr int rounds = 12;
  constexpr double factor = 1.5, shortest = 0.05, longest = 1.0;  // of the longest side
  const auto& sides = solid.ripples.box().sides;
  const double side = *std::max_element(sides.begin(), sides.end());
  Climbed best{from};
  best.evidence = evidence(solid, equations, best.prior, best.noise);
  for (int round = 0; round < rounds; ++round) {
    const double before = best.evidence;
    for (int knob = 0; knob < 4; ++knob) {
      for (const double by : {factor, 1.0 / factor}) {
        Climbed tried = best;
        double* knobs[] = {&tried.prior.height, &tried.prior.across, &tried.prior.along,
                           &tried.noise};
        *knobs[knob] *= by;
        tried.prior.across = std::clamp(tried.prior.across, shortest * side, longest * side);
        tried.prior.along = std::clamp(tried.prior.along, shortest * side, longest * side);
        tried.prior.height = std::min(tried.prior.height, highest);
        tried.evidence = evidence(solid, equations, tried.prior, tried.noise);
        if (tried.evidence <= best.evidence) continue;
        best = tried;
        break;
      }
    }
    if (best.evidence <= before) break;
  }
  return best;
}

}  // namespace

Ripples ripples_in(const Ripples::Box& box, int count) {
  constexpr int most = 24;  // half waves along a side
  std::vector<std::pair<double, Ripples::Orders>> all;
  for (int i = 0; i <= most; ++i) {
    for (int j = 0; j <= most; ++j) {
      for (int k = 0; k <= most; ++k) {
        const double x = i / box.sides[0], y = j / box.sides[1], z = k / box.sides[2];
        if (i + j + k > 0) all.push_back({x * x + y * y + z * z, {i, j, k}});
      }
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Ripples::Orders> orders;
  for (int n = 0; n < count; ++n) orders.push_back(all[std::size_t(n)].second);
  return Ripples(box, std::move(orders));
}

std::vector<double> wave_sigma(const Ripples& ripples, const RipplePrior& prior) {
  const double lengths = prior.across * prior.across * prior.along;
  const double density = prior.height * prior.height * matern * lengths;
  std::vector<double> sigma;
  for (std::size_t n = 0; n < ripples.orders().size(); ++n) {
    const Eigen::Vector3d frequency = frequency_of(ripples, n);
    const double across = prior.across * prior.across * frequency.head<2>().squaredNorm();
    const double along = prior.along * prior.along * frequency[2] * frequency[2];
    double variance = density * std::pow(1.0 + (across + along) / 3.0, -3.0);
    for (std::size_t axis = 0; axis < 3; ++axis)
      variance *= (ripples.orders()[n][axis] > 0 ? 2.0 : 1.0) / ripples.box().sides[axis];
    sigma.push_back(std::max(std::sqrt(variance), 1e-6 * prior.height));
  }
  return sigma;
}

RipplePrior likely_ripples(const GrowthSolid& solid, const SolidEquations& equations,
                           const std::vector<RipplePrior>& starts) {
  // Rings that wander further than a third of their distance could not be told apart.
  const double highest = usual_width(solid) / 3.0;
  Climbed best;
  for (const RipplePrior& start : starts) {
    const Climbed one = climbed(solid, equations, start, highest);
    if (one.evidence > best.evidence) best = one;
  }
  RipplePrior none = best.prior;
  none.height *= 1e-4;
  double without = -HUGE_VAL;
  for (double noise = 0.25 * best.noise; noise < 32.0 * best.noise; noise *= 1.2)
    without = std::max(without, evidence(solid, equations, none, noise));
  best.prior.gain = best.evidence - without;
  return best.prior;
}

}  // namespace hada
