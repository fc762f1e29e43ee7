#include "mechanics/facet_springs.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace hada {

std::vector<Spring> facet_springs(const std::vector<std::vector<int>>& facets,
                                  const std::vector<Eigen::Vector3d>& rest) {
  std::set<std::pair<int, int>> pairs;
  for (const auto& facet : facets) {
    for (std::size_t i = 0; i < facet.size(); ++i) {
      for (std::size_t j = i + 1; j < facet.size(); ++j) {
        pairs.insert(std::minmax(facet[i], facet[j]));
      }
    }
  }
  std::vector<Spring> springs;
  for (const auto& [a, b] : pairs) {
    springs.push_back({a, b, (rest[std::size_t(a)] - rest[std::size_t(b)]).norm()});
  }
  return springs;
}

SpringMotion::SpringMotion(std::vector<Spring> springs, const std::vector<Eigen::Vector3d>& places,
                           const std::vector<bool>& pinned, const SpringOptions& options)
    : springs_(std::move(springs)),
      place_(3 * places.size()),
      speed_(3 * places.size(), 0.0),
      force_(3 * places.size(), 0.0),
      share_(places.size(), 1.0),
      way_(4 * springs_.size()),
      damping_(options.damping) {
  const std::size_t n = places.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) place_[axis * n + i] = places[i][int(axis)];
  }
  std::vector<int> count(n, 0);
  for (const Spring& spring : springs_) {
    rest_.push_back(spring.length);
    ++count[std::size_t(spring.from)];
    ++count[std::size_t(spring.to)];
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (options.mass_by_springs) share_[i] = 1.0 / std::max(count[i], 1);
    if (!pinned.empty() && pinned[i]) share_[i] = 0.0;
  }
  const double stiffness = largest_stiffness();
  const auto is_stable = [&](double dt) {
    return damping_ * stiffness * dt * dt < 2.0 * (2.0 - damping_ * dt);
  };
  while (!is_stable(1.0 / substeps_)) ++substeps_;
}

double SpringMotion::largest_stiffness() const {
  // Power iteration on the springs' directions; a spring under tension is no stiffer than that.
  const std::size_t n = share_.size();
  std::vector<double> way(place_.size()), pull(place_.size());
  for (std::size_t i = 0; i < way.size(); ++i) way[i] = std::sin(1.0 + double(i) * 1.7);
  double stiffness = 0.0;
  for (int round = 0; round < 40; ++round) {
    std::fill(pull.begin(), pull.end(), 0.0);
    for (const Spring& spring : springs_) {
      const std::size_t a = std::size_t(spring.from), b = std::size_t(spring.to);
      Eigen::Vector3d u, d;
      for (int axis = 0; axis < 3; ++axis) {
        u[axis] = place_[std::size_t(axis) * n + b] - place_[std::size_t(axis) * n + a];
        d[axis] = way[std::size_t(axis) * n + b] - way[std::size_t(axis) * n + a];
      }
      const Eigen::Vector3d f = u * (u.dot(d) / std::max(u.squaredNorm(), 1e-300));
      for (int axis = 0; axis < 3; ++axis) {
        pull[std::size_t(axis) * n + a] -= f[axis];
        pull[std::size_t(axis) * n + b] += f[axis];
      }
    }
    double norm = 0.0;
    for (std::size_t i = 0; i < pull.size(); ++i) {
      pull[i] *= share_[i % n];
      norm += pull[i] * pull[i];
    }
    stiffness = std::sqrt(norm);
    if (stiffness == 0.0) return 0.0;
    for (std::size_t i = 0; i < way.size(); ++i) way[i] = pull[i] / stiffness;
  }
  constexpr double not_yet_converged = 1.1;
  return not_yet_converged * stiffness;
}

void SpringMotion::step(int count) {
  const std::size_t n = share_.size(), m = springs_.size();
  const double dt = 1.0 / substeps_;
  const double kept = 1.0 - damping_ * dt, taken = damping_ * dt;
  double* const x = place_.data();
  double* const f = force_.data();
  double* const w = way_.data();
  for (int k = 0; k < count * substeps_; ++k) {
    for (std::size_t s = 0; s < m; ++s) {
      const std::size_t a = std::size_t(springs_[s].from), b = std::size_t(springs_[s].to);
      w[s] = x[b] - x[a];
      w[m + s] = x[n + b] - x[n + a];
      w[2 * m + s] = x[2 * n + b] - x[2 * n + a];
    }
    const double* const rest = rest_.data();
    double* const pull = w + 3 * m;
    for (std::size_t s = 0; s < m; ++s) {  // no branches: the compiler takes several at once
      const double square = w[s] * w[s] + w[m + s] * w[m + s] + w[2 * m + s] * w[2 * m + s];
      pull[s] = 1.0 - rest[s] / std::sqrt(square + 1e-300);
    }
    std::fill(force_.begin(), force_.end(), 0.0);
    for (std::size_t s = 0; s < m; ++s) {
      const std::size_t a = std::size_t(springs_[s].from), b = std::size_t(springs_[s].to);
      const double fx = pull[s] * w[s], fy = pull[s] * w[m + s], fz = pull[s] * w[2 * m + s];
      f[a] += fx, f[n + a] += fy, f[2 * n + a] += fz;
      f[b] -= fx, f[n + b] -= fy, f[2 * n + b] -= fz;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double* const v = speed_.data() + axis * n;
      for (std::size_t i = 0; i < n; ++i) {
        v[i] = kept * v[i] + taken * share_[i] * f[axis * n + i];
        x[axis * n + i] += dt * v[i];
      }
    }
  }
}

std::vector<Eigen::Vector3d> SpringMotion::places() const {
  const std::size_t n = share_.size();
  std::vector<Eigen::Vector3d> places(n);
  for (std::size_t i = 0; i < n; ++i) places[i] = {place_[i], place_[n + i], place_[2 * n + i]};
  return places;
}

double SpringMotion::strain() const {
  const auto at = places();
  double worst = 0.0;
  for (const Spring& spring : springs_) {
    const double length = (at[std::size_t(spring.to)] - at[std::size_t(spring.from)]).norm();
    worst = std::max(worst, std::abs(length / spring.length - 1.0));
  }
  return worst;
}

}  // namespace hada
