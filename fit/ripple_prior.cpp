#include "fit/ripple_prior.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

namespace hada {
namespace {

constexpr double pi = std::numbers::pi;

/// Frequencies of a wave along x, y and z, radians for each unit of length.
Eigen::Vector3d frequency_of(const Ripples& ripples, std::size_t n) {
  Eigen::Vector3d frequency;
  for (std::size_t axis = 0; axis < 3; ++axis)
    frequency[Eigen::Index(axis)] = pi * ripples.orders()[n][axis] / ripples.box().sides[axis];
  return frequency;
}

/// Logarithm of the evidence, up to what all priors share.
double evidence(const GrowthSolid& solid, const SolidEquations& sums, const RipplePrior& prior,
                double noise, double together) {
  const double trust = 1.0 / (noise * noise * together);
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
         sums.count / together * std::log(noise);
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
  const double density = prior.height * prior.height * std::pow(2.0 * pi, 1.5) * lengths;
  std::vector<double> sigma;
  for (std::size_t n = 0; n < ripples.orders().size(); ++n) {
    const Eigen::Vector3d frequency = frequency_of(ripples, n);
    const double across = prior.across * prior.across * frequency.head<2>().squaredNorm();
    const double along = prior.along * prior.along * frequency[2] * frequency[2];
    double variance = density * std::exp(-0.5 * (across + along));
    for (std::size_t axis = 0; axis < 3; ++axis)
      variance *= (ripples.orders()[n][axis] > 0 ? 2.0 : 1.0) / ripples.box().sides[axis];
    sigma.push_back(std::max(std::sqrt(variance), 1e-6 * prior.height));
  }
  return sigma;
}

RipplePrior likely_ripples(const GrowthSolid& solid, const SolidEquations& equations,
                           const RipplePrior& from, double together) {
  constexpr int rounds = 12;
  constexpr double factor = 1.5;
  const auto& sides = solid.ripples.box().sides;
  const double longest = *std::max_element(sides.begin(), sides.end());
  RipplePrior best = from;
  double noise = 1.0;
  double highest = evidence(solid, equations, best, noise, together);
  for (int round = 0; round < rounds; ++round) {
    bool better = false;
    for (int knob = 0; knob < 4; ++knob) {
      for (const double by : {factor, 1.0 / factor}) {
        RipplePrior tried = best;
        double tried_noise = noise;
        double* knobs[] = {&tried.height, &tried.across, &tried.along, &tried_noise};
        *knobs[knob] *= by;
        tried.across = std::clamp(tried.across, 0.05 * longest, 0.6 * longest);
        tried.along = std::clamp(tried.along, 0.05 * longest, 0.6 * longest);
        const double reached = evidence(solid, equations, tried, tried_noise, together);
        if (reached <= highest) continue;
        highest = reached;
        best = tried;
        noise = tried_noise;
        better = true;
        break;
      }
    }
    if (!better) break;
  }
  RipplePrior none = best;
  none.height *= 1e-4;
  double without = -HUGE_VAL;
  for (double other = 0.25 * noise; other < 32.0 * noise; other *= 1.2)
    without = std::max(without, evidence(solid, equations, none, other, together));
  best.gain = highest - without;
  return best;
}

}  // namespace hada
