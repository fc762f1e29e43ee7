#include "fit/ring_shape.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/quantile.h"
#include "fit/growth_local.h"

namespace hada {
namespace {

constexpr int rounds = 12;
constexpr double at_rest = 1e-3;        // relative change of the scatter
constexpr double smallest_unit = 0.05;  // of a relative scatter
constexpr double loss_scale = 2.0;      // scatters, of the Cauchy loss
constexpr int longest_lag = 12;         // sectors over which scatter may hang together

/// What the normal equations are made of, the radii already eliminated.
struct Reduced {
  Eigen::MatrixXd normal;
  Eigen::VectorXd right;
  std::vector<double> weight, mean;    // of each ring: sum of weights, mean effective radius
  std::vector<Eigen::VectorXd> slope;  // of each ring: mean derivatives
};

/// Sums over all points, under `weights`.
///
/// rho, slopes  effective radius of each point and its derivatives, a column each
/// rows         room for the weighted derivatives
Reduced reduced(const std::vector<RingPoint>& points, int rings, const std::vector<double>& rho,
                const Eigen::MatrixXd& slopes, const std::vector<double>& weights,
                Eigen::MatrixXd& rows) {
  const Eigen::Index size = slopes.rows();
  Reduced sums{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size),
               std::vector<double>(std::size_t(rings), 1e-300),
               std::vector<double>(std::size_t(rings), 0.0),
               std::vector<Eigen::VectorXd>(std::size_t(rings), Eigen::VectorXd::Zero(size))};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto ring = std::size_t(points[i].ring);
    const auto slope = slopes.col(Eigen::Index(i));
    sums.weight[ring] += weights[i];
    sums.mean[ring] += weights[i] * rho[i];
    sums.slope[ring] += weights[i] * slope;
    rows.col(Eigen::Index(i)) = std::sqrt(weights[i]) * slope;
    sums.right += weights[i] * rho[i] * slope;
  }
  sums.normal.selfadjointView<Eigen::Lower>().rankUpdate(rows);
  Eigen::MatrixXd means(size, rings);
  for (std::size_t ring = 0; ring < std::size_t(rings); ++ring) {
    const double w = sums.weight[ring];
    sums.mean[ring] /= w;
    sums.slope[ring] /= w;
    means.col(Eigen::Index(ring)) = std::sqrt(w) * sums.slope[ring];
    sums.right -= w * sums.mean[ring] * sums.slope[ring];
  }
  sums.normal.selfadjointView<Eigen::Lower>().rankUpdate(means, -1.0);
  sums.normal = sums.normal.selfadjointView<Eigen::Lower>();
  return sums;
}

/// How many neighbours on a ring scatter as one: 1 + 2 sum of their correlations.
double design_effect(const std::vector<RingPoint>& points, const std::vector<double>& residuals,
                     double scatter) {
  double effect = 1.0;
  for (std::size_t lag = 1; lag <= longest_lag; ++lag) {
    double product = 0.0, square = 0.0;
    for (std::size_t i = lag; i < points.size(); ++i) {
      if (points[i].ring != points[i - lag].ring) continue;
      const double a = std::clamp(residuals[i], -3.0 * scatter, 3.0 * scatter);
      const double b = std::clamp(residuals[i - lag], -3.0 * scatter, 3.0 * scatter);
      product += a * b;
      square += 0.5 * (a * a + b * b);
    }
    if (product <= 0.05 * square) break;
    effect += 2.0 * product / square;
  }
  return effect;
}

}  // namespace

double gain_of(const RingShape& richer, const RingShape& plainer) {
  // Not `independent`: what hangs together from point to point is what more lobes could follow.
  const double points = 0.5 * richer.points;
  const double more =
      2.0 * (double(richer.frame.lobes.size()) - double(plainer.frame.lobes.size()));
  return 2.0 * points * std::log(plainer.scatter / richer.scatter) - more * std::log(points);
}

RingShape fitted_shape(const std::vector<RingPoint>& points, int rings, const GrowthFrame& start,
                       Scatter scatter) {
  RingShape shape;
  shape.frame = start;
  const Eigen::VectorXd prior = growth_prior(start);
  std::vector<double> rho(points.size()), residuals(points.size()), weights(points.size(), 1.0);
  std::vector<double> unit(points.size(), 1.0);  // of the scatter of each point
  Eigen::MatrixXd slopes(prior.size(), Eigen::Index(points.size())), rows = slopes;
  const auto look = [&] {
    for (std::size_t i = 0; i < points.size(); ++i)
      rho[i] = growth_at(shape.frame, points[i].place, slopes.col(Eigen::Index(i)));
    // The median of a ring does not mind points of another that were taken for its own.
    std::vector<std::vector<double>> of_ring{std::size_t(rings)};
    for (std::size_t i = 0; i < points.size(); ++i)
      of_ring[std::size_t(points[i].ring)].push_back(rho[i]);
    std::vector<double> sizes;
    if (shape.radii.empty()) {
      for (const auto& values : of_ring) shape.radii.push_back(median(values));
    }
    if (scatter == Scatter::relative) {
      const double middle = median(rho);
      for (std::size_t i = 0; i < points.size(); ++i)
        unit[i] = std::max(rho[i] / middle, smallest_unit);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      residuals[i] = rho[i] - shape.radii[std::size_t(points[i].ring)];
      sizes.push_back(std::abs(residuals[i]) / unit[i]);
    }
    shape.scatter = std::max(1.4826 * median(sizes), 1e-9);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double off = residuals[i] / (loss_scale * shape.scatter * unit[i]);
      weights[i] = 1.0 / (unit[i] * unit[i] * (1.0 + off * off));
    }
  };
  Reduced sums;
  look();
  for (int round = 0; round < rounds; ++round) {
    sums = reduced(points, rings, rho, slopes, weights, rows);
    const Eigen::VectorXd state = packed(shape.frame);
    const double variance = shape.scatter * shape.scatter;
    Eigen::MatrixXd normal = sums.normal;
    normal.diagonal() += variance * prior;
    normal.diagonal() *= 1.0 + 1e-10;
    const Eigen::VectorXd move =
        normal.ldlt().solve(-sums.right - variance * prior.cwiseProduct(state));
    shape.frame = unpacked(shape.frame, state + move);
    for (std::size_t ring = 0; ring < std::size_t(rings); ++ring)
      shape.radii[ring] = sums.mean[ring] + sums.slope[ring].dot(move);
    const double before = shape.scatter;
    look();
    if (round > 2 && std::abs(shape.scatter - before) < at_rest * before) break;
  }
  shape.points = double(points.size());
  const double effect = design_effect(points, residuals, shape.scatter);
  shape.independent = double(points.size()) / effect;
  // The Cauchy loss is worth about 0.9 of least squares for Gaussian scatter; its weights say less.
  double mean_weight = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    mean_weight += weights[i] * unit[i] * unit[i] / double(points.size());
  const double variance = effect * shape.scatter * shape.scatter * mean_weight;
  sums = reduced(points, rings, rho, slopes, weights, rows);
  Eigen::MatrixXd information = sums.normal / variance;
  information.diagonal() += prior;
  information.diagonal() *= 1.0 + 1e-10;
  shape.covariance =
      information.ldlt().solve(Eigen::MatrixXd::Identity(prior.size(), prior.size()));
  shape.pith_sigma = shape.covariance.diagonal().head<2>().cwiseSqrt();
  for (std::size_t l = 0; l < start.lobes.size(); ++l)
    shape.lobe_sigma.push_back(
        shape.covariance.diagonal().segment<2>(Eigen::Index(2 + 2 * l)).cwiseSqrt());
  for (std::size_t ring = 0; ring < std::size_t(rings); ++ring) {
    const auto& slope = sums.slope[ring];
    shape.radii_sigma.push_back(
        std::sqrt(variance / sums.weight[ring] + slope.dot(shape.covariance * slope)));
  }
  return shape;
}

}  // namespace hada
