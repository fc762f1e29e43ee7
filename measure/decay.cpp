#include "measure/decay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

namespace hada {
namespace {

constexpr std::size_t least_rings = 8;
constexpr double least_floor = 1e-12;  // of the strongest ring: no map of floats knows less

struct Ring {
  double frequency;
  double density;
  double weight;  // degrees of freedom over two
};

// The logarithms of plateau, corner, slope and floor: all of them are above 0.
using Parameters = Eigen::Vector4d;

// The curve at a frequency, and the derivatives of its logarithm.
struct Point {
  double value;
  Parameters gradient;
};

Point point_at(const Parameters& p, double frequency) {
  const double slope = std::exp(p[2]);
  const double x = std::pow(frequency / std::exp(p[1]), 2);
  const double falling = std::exp(p[0] - 0.5 * slope * std::log1p(x));
  const double floor = std::exp(p[3]);
  const double value = falling + floor;
  const double share = falling / value;
  return {
      value,
      {share, share * slope * x / (1.0 + x), -share * 0.5 * slope * std::log1p(x), floor / value}};
}

double deviance(const Parameters& p, const std::vector<Ring>& rings) {
  double sum = 0.0;
  for (const Ring& ring : rings) {
    const double ratio = ring.density / point_at(p, ring.frequency).value;
    sum += 2.0 * ring.weight * (ratio - 1.0 - std::log(ratio));
  }
  return sum;
}

Eigen::Matrix4d information(const Parameters& p, const std::vector<Ring>& rings) {
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  for (const Ring& ring : rings) {
    const auto gradient = point_at(p, ring.frequency).gradient;
    sum += ring.weight * gradient * gradient.transpose();
  }
  return sum;
}

// Fisher scoring with Levenberg's damping.
Parameters best_from(Parameters p, const std::vector<Ring>& rings) {
  constexpr int most_steps = 200;
  constexpr double hardest = 1e8;
  double damping = 1e-3;
  double cost = deviance(p, rings);
  for (int step = 0; step < most_steps && damping < hardest; ++step) {
    Parameters down = Parameters::Zero();
    for (const Ring& ring : rings) {
      const Point point = point_at(p, ring.frequency);
      down += ring.weight * (ring.density / point.value - 1.0) * point.gradient;
    }
    Eigen::Matrix4d matrix = information(p, rings);
    matrix.diagonal() *= 1.0 + damping;
    matrix.diagonal().array() += 1e-9;  // a floor that nothing is known of
    const Parameters tried = p + matrix.ldlt().solve(down).cwiseMax(-1.0).cwiseMin(1.0);
    const double now = deviance(tried, rings);
    if (!(now < cost)) {
      damping *= 8.0;
      continue;
    }
    const bool done = cost - now < 1e-9 * (1.0 + cost);
    p = tried;
    cost = now;
    damping = std::max(damping / 4.0, 1e-9);
    if (done) break;
  }
  return p;
}

std::vector<Ring> usable(const Rings& rings) {
  std::vector<Ring> found;
  for (std::size_t i = 0; i < rings.density.size(); ++i) {
    const double density = rings.density[i], sigma = rings.sigma[i];
    if (!(density > 0.0) || !(sigma > 0.0)) continue;
    found.push_back({rings.frequency[i], density, std::pow(density / sigma, 2)});
  }
  return found;
}

}  // namespace

std::optional<double> Decay::hurst() const {
  const double found = 0.5 * (slope - 2.0), sigma = 0.5 * slope_sigma;
  if (found + 2.0 * sigma < 0.0 || found - 2.0 * sigma > 1.0) return std::nullopt;
  return found;
}

std::optional<Decay> decay_of(const Rings& rings) {
  const std::vector<Ring> used = usable(rings);
  if (used.size() < least_rings) return std::nullopt;
  const auto [weakest, strongest] = std::minmax_element(
      used.begin(), used.end(), [](const Ring& a, const Ring& b) { return a.density < b.density; });
  const double least = least_floor * strongest->density;
  Parameters best = Parameters::Zero();
  double cost = HUGE_VAL;
  for (const double slope : {3.0, 6.0}) {
    for (const std::size_t corner : {used.size() / 32, used.size() / 8, used.size() / 3}) {
      const Parameters start(std::log(strongest->density), std::log(used[corner].frequency),
                             std::log(slope), std::log(std::max(0.5 * weakest->density, least)));
      const Parameters found = best_from(start, used);
      const double left = deviance(found, used);
      if (left < cost) {
        cost = left;
        best = found;
      }
    }
  }
  Decay decay;
  decay.misfit = std::sqrt(cost / double(used.size() - 4));
  Eigen::Matrix4d matrix = information(best, used);
  matrix.diagonal().array() += 1e-9;
  const Parameters sigma =
      std::max(decay.misfit, 1.0) * matrix.inverse().diagonal().cwiseMax(0.0).cwiseSqrt();
  const auto put = [&](int i, double& value, double& error) {
    value = std::exp(best[i]);
    error = value * sigma[i];
  };
  put(0, decay.plateau, decay.plateau_sigma);
  put(1, decay.corner, decay.corner_sigma);
  put(2, decay.slope, decay.slope_sigma);
  put(3, decay.floor, decay.floor_sigma);
  return decay;
}

}  // namespace hada
