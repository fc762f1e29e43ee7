#include "fit/solid_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/parallel.h"
#include "core/quantile.h"
#include "fit/growth_local.h"

namespace hada {
namespace {

constexpr double loss_scale = 2.5;  // scatters, of the Cauchy loss
constexpr double least_slope = 0.03;
constexpr int rounds = 8;
constexpr int longest_lag = 12;       // neighbours over which scatter may hang together
constexpr double radius_prior = 0.5;  // of the width of a ring
constexpr double held_radius = 0.05;  // the same where ripples can take its place

Eigen::VectorXd precision_of(const GrowthSolid& solid, const SolidPrior& prior) {
  Eigen::VectorXd precision(solid.size());
  for (std::size_t k = 0; k < solid.radii.size(); ++k) {
    const double inner = k > 0 ? solid.radii[k - 1] : 0.0;
    const double share = prior.ripples.empty() ? radius_prior : held_radius;
    const double loose = share * (solid.radii[k] - inner);
    precision[solid.radii_at() + Eigen::Index(k)] = 1.0 / (loose * loose);
  }
  precision.head<2>().setConstant(1.0 / (prior.pith * prior.pith));
  precision.segment<2>(2).setConstant(1.0 / (prior.lean * prior.lean));
  precision[4] = 1.0 / (prior.taper * prior.taper);
  const Eigen::VectorXd lobes = growth_prior(solid.frame);
  precision.segment(solid.lobes_at(), lobes.size() - 2) = lobes.tail(lobes.size() - 2);
  for (std::size_t n = 0; n < prior.ripples.size(); ++n)
    precision[solid.ripples_at() + Eigen::Index(n)] = 1.0 / (prior.ripples[n] * prior.ripples[n]);
  return precision;
}

/// By how much the means of whole runs scatter more than those of places that know nothing of each
/// other: what hangs together over long ways.
double run_effect(const std::vector<RingSighting>& seen, const std::vector<double>& off,
                  std::size_t face, double scatter) {
  double squares = 0.0, runs = 0.0, sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i <= seen.size(); ++i) {
    const bool ends =
        i == seen.size() ||
        (i > 0 && (seen[i].run != seen[i - 1].run || seen[i].face != seen[i - 1].face));
    if (ends && count > 0.0) {
      squares += sum * sum / count;
      runs += 1.0;
      sum = count = 0.0;
    }
    if (i == seen.size() || seen[i].face != face) continue;
    sum += std::clamp(off[i], -3.0 * scatter, 3.0 * scatter);
    count += 1.0;
  }
  return runs > 0.0 ? squares / runs / (scatter * scatter) : 1.0;
}

/// 1 + 2 sum of the correlations of neighbours, or what whole runs have in common if that is more.
double design_effect(const std::vector<RingSighting>& seen, const std::vector<double>& off,
                     std::size_t face, double scatter) {
  double effect = 1.0;
  for (std::size_t lag = 1; lag <= longest_lag; ++lag) {
    double product = 0.0, square = 0.0;
    for (std::size_t i = lag; i < seen.size(); ++i) {
      const RingSighting &here = seen[i], &back = seen[i - lag];
      if (here.face != face || back.face != face || here.run != back.run) continue;
      const double a = std::clamp(off[i], -3.0 * scatter, 3.0 * scatter);
      const double b = std::clamp(off[i - lag], -3.0 * scatter, 3.0 * scatter);
      product += a * b;
      square += 0.5 * (a * a + b * b);
    }
    if (product <= 0.05 * square) break;
    effect += 2.0 * product / square;
  }
  return std::max(effect, run_effect(seen, off, face, scatter));
}

/// Everything that changes while the solid is being fitted.
class Descent {
 public:
  Descent(const std::vector<RingSighting>& seen, const std::vector<RingThread>& threads,
          const GrowthSolid& start, const SolidPrior& prior, std::size_t faces, double noise)
      : seen_(seen),
        threads_(threads),
        mean_(start.state()),
        precision_(precision_of(start, prior)),
        noise_(noise),
        together_(prior.together) {
    fit_.solid = start;
    fit_.faces.resize(2 * faces);  // those of their threads behind
    group_.reserve(seen.size() + threads.size());
    for (const RingSighting& one : seen) group_.push_back(one.face);
    for (const RingThread& one : threads) group_.push_back(faces + one.face);
    off_.resize(group_.size());
    slope_.assign(group_.size(), 1.0);
    weight_.assign(group_.size(), 0.0);
    rows_.resize(start.size(), Eigen::Index(group_.size()));
  }

  SolidFit run() {
    look();
    for (int round = 0; round < rounds; ++round) {
      const Eigen::VectorXd state = fit_.solid.state();
      const auto information = normal_matrix();
      Eigen::VectorXd right = precision_.cwiseProduct(mean_ - state);
      for (std::size_t i = 0; i < group_.size(); ++i)
        right -= weight_[i] * off_[i] * slope_[i] * rows_.col(Eigen::Index(i));
      const Eigen::VectorXd move = information.ldlt().solve(right);
      fit_.solid.set_state(state + move);
      look();
      if (move.segment<2>(2).norm() + std::abs(move[4]) < 1e-6 && round > 1) break;
    }
    const std::size_t faces = fit_.faces.size() / 2;
    for (std::size_t face = 0; face < faces; ++face) {
      auto& one = fit_.faces[face];
      if (one.sightings > 0) one.effect = design_effect(seen_, off_, face, one.scatter);
    }
    set_equations();
    for (std::size_t i = 0; i < seen_.size(); ++i)
      weight_[i] *= together_ / fit_.faces[group_[i]].effect;
    const Eigen::Index size = fit_.solid.size();
    fit_.solid.covariance = normal_matrix().ldlt().solve(Eigen::MatrixXd::Identity(size, size));
    fit_.faces.resize(faces);
    return fit_;
  }

 private:
  /// Residuals across the lines, scatter of each face, weights of rho.
  void look() {
    const GrowthSolid& solid = fit_.solid;
    for_each_index(int(seen_.size()), [&](int index) {
      const auto i = std::size_t(index);
      const SolidLocal local = local_of(solid, seen_[i].place);
      auto row = rows_.col(index);
      row.setZero();
      row.head(solid.radii_at()) = local.slopes;
      row[solid.radii_at() + Eigen::Index(seen_[i].ring)] = -1.0;
      // Along the picture, as the growth is now: else a flatter growth would seem to fit better.
      const Eigen::Map<const Eigen::Vector3d> across(seen_[i].across.data());
      slope_[i] = std::max(local.gradient.dot(across), least_slope);
      off_[i] = (local.rho - solid.radii[seen_[i].ring]) / slope_[i];
    });
    for_each_index(int(threads_.size()), [&](int index) {
      const RingThread& thread = threads_[std::size_t(index)];
      const auto i = seen_.size() + std::size_t(index);
      const SolidLocal from = local_of(solid, thread.from), to = local_of(solid, thread.to);
      StemVector within, without;
      double length = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
        length = std::hypot(length, thread.to[k] - thread.from[k]);
      for (std::size_t k = 0; k < 3; ++k) {
        const double middle = 0.5 * (thread.from[k] + thread.to[k]);
        within[k] = middle - 0.5 * length * thread.across[k];
        without[k] = middle + 0.5 * length * thread.across[k];
      }
      const SolidLocal low = local_of(solid, within), high = local_of(solid, without);
      const double slope = (high.rho - low.rho) / length;
      slope_[i] = std::max(std::abs(slope), least_slope);
      off_[i] = (to.rho - from.rho) / slope_[i];
      // The slope changes as well: else flat growth, of which all is one ring, would fit best.
      auto row = rows_.col(Eigen::Index(i));
      row.setZero();
      const double share = (to.rho - from.rho) / (slope < 0.0 ? -slope_[i] : slope_[i]) / length;
      row.head(solid.radii_at()) = to.slopes - from.slopes - share * (high.slopes - low.slopes);
    });
    std::vector<std::vector<double>> sizes(fit_.faces.size());
    for (std::size_t i = 0; i < group_.size(); ++i) sizes[group_[i]].push_back(std::abs(off_[i]));
    for (std::size_t face = 0; face < sizes.size(); ++face) {
      auto& one = fit_.faces[face];
      one.sightings = int(sizes[face].size());
      if (one.sightings > 0) one.scatter = std::max(1.4826 * median(sizes[face]), noise_);
    }
    for (std::size_t i = 0; i < group_.size(); ++i) {
      const double scatter = fit_.faces[group_[i]].scatter;
      const double relative = off_[i] / (loss_scale * scatter);
      const double unit = scatter * slope_[i];
      weight_[i] = 1.0 / (unit * unit * (1.0 + relative * relative));
      if (i < seen_.size()) weight_[i] /= together_;  // threads lie apart from each other
    }
  }

  void set_equations() {
    SolidEquations& sums = fit_.equations;
    const Eigen::VectorXd state = fit_.solid.state();
    sums.normal = weighted_rows();
    sums.right = Eigen::VectorXd::Zero(state.size());
    for (std::size_t i = 0; i < group_.size(); ++i) {
      const auto row = rows_.col(Eigen::Index(i));
      const double offset = off_[i] * slope_[i] - row.dot(state);
      const double unit = fit_.faces[group_[i]].scatter * slope_[i];
      sums.right += weight_[i] * offset * row;
      sums.squares += weight_[i] * offset * offset;
      sums.count += weight_[i] * unit * unit;
    }
    sums.mean = mean_;
    sums.precision = precision_;
  }

  Eigen::MatrixXd normal_matrix() const {
    Eigen::MatrixXd normal = weighted_rows();
    normal.diagonal() += precision_;
    return normal;
  }

  Eigen::MatrixXd weighted_rows() const {
    Eigen::MatrixXd scaled(rows_.rows(), rows_.cols());
    for (Eigen::Index i = 0; i < rows_.cols(); ++i)
      scaled.col(i) = std::sqrt(weight_[std::size_t(i)]) * rows_.col(i);
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(rows_.rows(), rows_.rows());
    normal.selfadjointView<Eigen::Lower>().rankUpdate(scaled);
    return Eigen::MatrixXd(normal.selfadjointView<Eigen::Lower>());
  }

  const std::vector<RingSighting>& seen_;
  const std::vector<RingThread>& threads_;
  std::vector<std::size_t> group_;  // of sightings, then threads: whose scatter they share
  Eigen::VectorXd mean_, precision_;
  double noise_;
  SolidFit fit_;
  double together_;
  std::vector<double> off_, slope_, weight_;
  Eigen::MatrixXd rows_;
};

}  // namespace

SolidFit fitted_solid(const std::vector<RingSighting>& sightings, const GrowthSolid& start,
                      const SolidPrior& prior, std::size_t faces, double noise,
                      const std::vector<RingThread>& threads) {
  return Descent(sightings, threads, start, prior, faces, noise).run();
}

}  // namespace hada
