#include "fit/grain_nuisance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Dense>

#include "fit/solve.h"
#include "fit/whittle.h"

namespace hada {
namespace {

constexpr std::size_t with_scale = 8, without = 6;  // nuisances
constexpr std::array known_to{log_steeper_sigma, log_steeper_sigma, log_scale_sigma,
                              log_aspect_sigma};  // beforehand, of the last of them
constexpr std::array<SolverBounds, with_scale> bounds{{{-4.0, 1.0},
                                                       {-4.0, 1.1},
                                                       {-24.0, 0.7},
                                                       {-5.0, 0.7},
                                                       {-1.0, 1.0},
                                                       {-1.0, 1.0},
                                                       {-0.45, 0.45},
                                                       {-0.2, 0.2}}};

std::vector<double> packed(const GrainNuisance& n, GrainScale scale) {
  std::vector<double> p{std::log(n.variance), std::log(n.blur_px),   std::log(n.floor),
                        std::log(n.step),     std::log(n.steeper_x), std::log(n.steeper_y),
                        std::log(n.scale),    std::log(n.aspect)};
  if (scale == GrainScale::one) p.resize(without);
  return p;
}

GrainNuisance unpacked(const double* p, const GrainNuisance& start, GrainScale scale) {
  GrainNuisance n{std::exp(p[0]), std::exp(p[1]), std::exp(p[2]), std::exp(p[3]),
                  std::exp(p[4]), std::exp(p[5]), start.scale,    start.aspect};
  if (scale == GrainScale::about_one) {
    n.scale = std::exp(p[6]);
    n.aspect = std::exp(p[7]);
  }
  return n;
}

constexpr std::size_t steeper = 4;  // the first of the two slopes

/// Residuals of all cells, then those of what is known beforehand of the slopes and, if they are
/// free, of scale and aspect; and their derivatives.
///
/// These go by way of the expected power, whose differences are cheap.
class GrainResiduals {
 public:
  GrainResiduals(const GrainModel& model, const GrainSpectrum& spectrum, const GrainNuisance& start,
                 GrainScale scale)
      : model_(model), spectrum_(spectrum), start_(start), scale_(scale) {}

  int parameters() const { return int(scale_ == GrainScale::one ? without : with_scale); }
  int count() const { return int(spectrum_.power.size()) + parameters() - int(steeper); }

  void operator()(const double* p, double* r, double* jacobian) const {
    std::vector<double> expected, moved;
    expect(p, expected);
    const std::size_t cells = expected.size(), n = std::size_t(parameters());
    for (std::size_t k = 0; k < cells; ++k) {
      r[k] = spectrum_.count[k] == 0.0
                 ? 0.0
                 : std::sqrt(spectrum_.count[k]) *
                       deviance_residual(std::log(spectrum_.power[k] / expected[k]));
    }
    for (std::size_t k = steeper; k < n; ++k) r[cells + k - steeper] = p[k] / known_to[k - steeper];
    if (!jacobian) return;
    std::fill(jacobian, jacobian + n * std::size_t(count()), 0.0);
    for (std::size_t k = steeper; k < n; ++k)
      jacobian[(cells + k - steeper) * n + k] = 1.0 / known_to[k - steeper];
    constexpr double h = 1e-5;
    std::vector<double> q(p, p + n);
    for (std::size_t parameter = 0; parameter < n; ++parameter) {
      q[parameter] += h;
      expect(q.data(), moved);
      q[parameter] = p[parameter];
      for (std::size_t k = 0; k < cells; ++k) {
        if (spectrum_.count[k] == 0.0) continue;
        // Of sqrt(2 n (x - 1 - ln x)) with x = power / expected; near 1 by its limit.
        const double off = spectrum_.power[k] / expected[k] - 1.0;
        const double rise =
            std::abs(off) < 1e-6 ? std::sqrt(spectrum_.count[k]) : spectrum_.count[k] * off / r[k];
        jacobian[k * n + parameter] = -rise * (moved[k] / expected[k] - 1.0) / h;
      }
    }
  }

 private:
  void expect(const double* p, std::vector<double>& expected) const {
    const GrainNuisance nuisance = unpacked(p, start_, scale_);
    if (scale_ == GrainScale::one) return expected_cells(model_, nuisance, spectrum_, expected);
    GrainModel model = model_;
    rescale(model, spectrum_, nuisance.scale, nuisance.aspect);
    expected_cells(model, nuisance, spectrum_, expected);
  }

  const GrainModel& model_;
  const GrainSpectrum& spectrum_;
  GrainNuisance start_;
  GrainScale scale_;
};

/// The integral over scale and aspect by Laplace's method, of what is known beforehand times the
/// likelihood over its best, in nats.
///
/// The six others are as wide with a known scale: what counts is by how much the two narrow them
/// and are narrowed.
double occam_factor(const GrainResiduals& residuals, const std::vector<double>& p) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  RowMajor jacobian(residuals.count(), residuals.parameters());
  std::vector<double> r(static_cast<std::size_t>(residuals.count()));
  residuals(p.data(), r.data(), jacobian.data());
  Eigen::MatrixXd information = jacobian.transpose() * jacobian;
  constexpr double spread = 3.0;  // of the logarithms of the six, so that none is without bounds
  for (Eigen::Index k = 0; k < Eigen::Index(without); ++k)
    information(k, k) += 1.0 / (spread * spread);
  const auto log_determinant = [](const Eigen::MatrixXd& m) {
    return 2.0 * Eigen::MatrixXd(m.llt().matrixL()).diagonal().array().log().sum();
  };
  const double off = p[6] / log_scale_sigma, stretched = p[7] / log_aspect_sigma;
  return 0.5 * (off * off + stretched * stretched) + std::log(log_scale_sigma * log_aspect_sigma) +
         0.5 * (log_determinant(information) -
                log_determinant(information.topLeftCorner(without, without)));
}

}  // namespace

GrainFit fit_nuisance(GrainModel& model, const GrainSpectrum& spectrum, const GrainNuisance& start,
                      int most_iterations, GrainScale scale) {
  rescale(model, spectrum, start.scale, start.aspect);
  const GrainResiduals residuals(model, spectrum, start, scale);
  const std::vector<SolverBounds> within(bounds.begin(), bounds.begin() + residuals.parameters());
  const auto ending = descend({packed(start, scale)}, within, residuals.count(), residuals,
                              {.max_iterations = most_iterations, .tolerance = 1e-7})
                          .front();
  GrainFit fit{unpacked(ending.packed.data(), start, scale)};
  if (scale == GrainScale::about_one) {
    fit.occam = occam_factor(residuals, ending.packed);
    rescale(model, spectrum, fit.nuisance.scale, fit.nuisance.aspect);
  }
  fit.cost = grain_cost(model, fit.nuisance, spectrum);
  return fit;
}

}  // namespace hada
