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

Eigen::VectorXd precision_of(const GrowthSolid& solid, const SolidPrior& prior) {
  Eigen::VectorXd precision(solid.size());
  for (std::size_t k = 0; k < solid.radii.size(); ++k) {
    const double inner = k > 0 ? solid.radii[k - 1] : 0.0;
    const double loose = radius_prior * (solid.radii[k] - inner);
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
  Descent(const std::vector<RingSighting>& seen, const GrowthSolid& start, const SolidPrior& prior,
          std::size_t faces, double noise)
      : seen_(seen),
        mean_(start.state()),
        precision_(precision_of(start, prior)),
        noise_(noise),
        together_(prior.together) {
    fit_.solid = start;
    fit_.faces.resize(faces);
    off_.resize(seen.size());
    slope_.assign(seen.size(), 1.0);
    weight_.assign(seen.size(), 0.0);
    rows_.resize(start.size(), Eigen::Index(seen.size()));
  }

  SolidFit run() {
    look();
    for (int round = 0; round < rounds; ++round) {
      const Eigen::VectorXd state = fit_.solid.state();
      const auto information = normal_matrix();
      Eigen::VectorXd right = precision_.cwiseProduct(mean_ - state);
      for (std::size_t i = 0; i < seen_.size(); ++i)
        right -= weight_[i] * off_[i] * slope_[i] * rows_.col(Eigen::Index(i));
      const Eigen::VectorXd move = information.ldlt().solve(right);
      fit_.solid.set_state(state + move);
      look();
      if (move.segment<2>(2).norm() + std::abs(move[4]) < 1e-6 && round > 1) break;
    }
    for (std::size_t face = 0; face < fit_.faces.size(); ++face) {
      auto& one = fit_.faces[face];
      if (one.sightings > 0) one.effect = design_effect(seen_, off_, face, one.scatter);
    }
    set_equations();
    for (std::size_t i = 0; i < seen_.size(); ++i)
      weight_[i] *= together_ / fit_.faces[seen_[i].face].effect;
    const Eigen::Index size = fit_.solid.size();
    fit_.solid.covariance = normal_matrix().ldlt().solve(Eigen::MatrixXd::Identity(size, size));
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
    std::vector<std::vector<double>> sizes(fit_.faces.size());
    for (std::size_t i = 0; i < seen_.size(); ++i)
      sizes[seen_[i].face].push_back(std::abs(off_[i]));
    for (std::size_t face = 0; face < sizes.size(); ++face) {
      auto& one = fit_.faces[face];
      one.sightings = int(sizes[face].size());
      if (one.sightings > 0) one.scatter = std::max(1.4826 * median(sizes[face]), noise_);
    }
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const double scatter = fit_.faces[seen_[i].face].scatter;
      const double relative = off_[i] / (loss_scale * scatter);
      const double unit = scatter * slope_[i];
      weight_[i] = 1.0 / (unit * unit * (1.0 + relative * relative) * together_);
    }
  }

  void set_equations() {
    SolidEquations& sums = fit_.equations;
    const Eigen::VectorXd state = fit_.solid.state();
    sums.normal = weighted_rows();
    sums.right = Eigen::VectorXd::Zero(state.size());
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const auto row = rows_.col(Eigen::Index(i));
      const double offset = off_[i] * slope_[i] - row.dot(state);
      const double unit = fit_.faces[seen_[i].face].scatter * slope_[i];
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
  Eigen::VectorXd mean_, precision_;
  double noise_;
  SolidFit fit_;
  double together_;
  std::vector<double> off_, slope_, weight_;
  Eigen::MatrixXd rows_;
};

}  // namespace

SolidFit fitted_solid(const std::vector<RingSighting>& sightings, const GrowthSolid& start,
                      const SolidPrior& prior, std::size_t faces, double noise) {
  return Descent(sightings, start, prior, faces, noise).run();
}

}  // namespace hada
