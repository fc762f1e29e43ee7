#include "reconstruct/normal_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <Eigen/Dense>

#include "core/quantile.h"
#include "reconstruct/noise.h"
#include "reconstruct/reweighted.h"
#include "reconstruct/shared_fit.h"

namespace hada {
namespace {

constexpr std::size_t pilot_pixels = 4000;
constexpr int curve_lights = 6;  // fewer leave a pixel too little to tell a curve by
constexpr double worthwhile =
    0.03;  // of the variance of a sample, that a shared curve must take away
// Of a light whose makers state no error: a sixth of a degree, or 0.3 % of its strength.
constexpr double least_light_sigma = 0.003;
constexpr double significant = 25.0;  // chi-squared of one degree of freedom: five sigma

std::vector<float> pseudo_inverse(const Tile& tile) {
  Eigen::MatrixX3d directions(tile.lights, 3);
  for (int k = 0; k < tile.lights; ++k) {
    const auto i = std::size_t(k);
    directions.row(k) << tile.x_to[i], tile.y_to[i], tile.z_to[i];
  }
  const Eigen::Matrix3d normal_matrix = directions.transpose() * directions;
  const Eigen::MatrixXd inverse = normal_matrix.inverse() * directions.transpose();
  std::vector<float> rows;
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < tile.lights; ++k) rows.push_back(float(inverse(axis, k)));
  }
  return rows;
}

Tile pilot(const TileSource& source) {
  const Mask& mask = source.stack.mask;
  const auto inside =
      std::size_t(std::count_if(mask.begin(), mask.end(), [](auto m) { return m; }));
  const std::size_t step = std::max<std::size_t>(1, inside / pilot_pixels) | 1;
  std::vector<std::pair<int, int>> chosen_pixels;
  std::size_t passed = 0;
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (mask(row, col) && passed++ % step == step / 2) chosen_pixels.emplace_back(row, col);
    }
  }
  Tile tile = source.tile(int(chosen_pixels.size()), true);
  int band = 0;  // the first row that is still held
  for (int i = 0; i < tile.pixels; ++i) {
    const auto [row, col] = chosen_pixels[std::size_t(i)];
    source.fill(tile, i, row, col, 1);
    constexpr int most_rows = 64;
    if (row < band + most_rows) continue;
    source.let_go(band, row + 1);
    band = row + 1;
  }
  source.let_go(band, mask.rows());
  return tile;
}

struct PixelNoise {
  double rho;
  double variance;
};

// One variance for each pixel that has residuals, in the order of the albedo.
std::vector<PixelNoise> residual_variances(const Tile& tile) {
  std::vector<PixelNoise> found;
  for (int i = 0; i < tile.pixels; ++i) {
    const auto pixel = std::size_t(i);
    const Eigen::Vector3d scaled(tile.x[pixel], tile.y[pixel], tile.z[pixel]);
    double squares = 0.0;
    double freedom = -3.0;
    for (int k = 0; k < tile.lights; ++k) {
      const std::size_t j = tile.near ? tile.at(k, i) : std::size_t(k);
      const Eigen::Vector3d l(tile.x_to[j], tile.y_to[j], tile.z_to[j]);
      const double w = tile.weight[tile.at(k, i)];
      squares += w * std::pow(tile.grey[tile.at(k, i)] - scaled.dot(l), 2);
      freedom += w;
    }
    if (freedom < 0.5 || !(scaled.norm() > 0.0)) continue;
    found.push_back({scaled.norm(), squares / (freedom * median_of_chi_squared(freedom))});
  }
  std::sort(found.begin(), found.end(),
            [](const PixelNoise& a, const PixelNoise& b) { return a.rho < b.rho; });
  return found;
}

// A straight line through the medians of the darker and of the brighter half.
NoiseLaw noise_law(const Tile& tile) {
  const std::vector<PixelNoise> pixels = residual_variances(tile);
  if (pixels.size() < 20) return {float(prior_noise * prior_noise), 0.0f};
  const auto half = [&](std::size_t begin, std::size_t end) {
    std::vector<double> rho, variance;
    for (std::size_t i = begin; i < end; ++i) {
      rho.push_back(pixels[i].rho);
      variance.push_back(pixels[i].variance);
    }
    return PixelNoise{median(std::move(rho)), median(std::move(variance))};
  };
  const PixelNoise dark = half(0, pixels.size() / 2);
  const PixelNoise bright = half(pixels.size() / 2, pixels.size());
  const double shot =
      std::clamp((bright.variance - dark.variance) / (bright.rho - dark.rho + 1e-12), 0.0,
                 dark.variance / dark.rho);
  return {float(std::max(0.0, dark.variance - shot * dark.rho)), float(shot)};
}

// A bounce coefficient times the albedo in the unit of the pictures is an albedo: at most 1.
float possible_bounce(float coefficient, const Tile& tile) {
  std::vector<double> rho;
  for (int i = 0; i < tile.pixels; ++i) {
    const auto pixel = std::size_t(i);
    rho.push_back(std::hypot(tile.x[pixel], tile.y[pixel], tile.z[pixel]));
  }
  const double bright = quantile(std::move(rho), 0.95);
  return bright > 0.0 ? std::clamp(coefficient, 0.0f, float(1.0 / bright)) : 0.0f;
}

// Whether most of what the best coefficient explains is explained by one that an albedo can have.
// Where the best lies far beyond all of them, or is less than none, something else is at work.
bool is_bounce(float coefficient, const Tile& tile) {
  if (coefficient <= 0.0f) return false;
  const float share = possible_bounce(coefficient, tile) / coefficient;
  return share * (2.0f - share) > 0.5f;  // of the misfit that the best takes away
}

double turn_by_bounce(Tile tile) {
  const auto normals_of = [](const Tile& t) {
    std::vector<Eigen::Vector3d> normals;
    for (std::size_t i = 0; i < std::size_t(t.pixels); ++i) {
      normals.push_back(Eigen::Vector3d(t.x[i], t.y[i], t.z[i]).normalized());
    }
    return normals;
  };
  const std::vector<Eigen::Vector3d> before = normals_of(tile);
  SharedTerms terms;
  terms.bounce = 0.5f * possible_bounce(std::numeric_limits<float>::max(), tile);
  take_off(tile, terms);
  refit_biweight(tile);
  const std::vector<Eigen::Vector3d> after = normals_of(tile);
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i].isZero() || after[i].isZero()) continue;
    squares += (after[i] - before[i]).squaredNorm();
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

struct Told {
  SharedTerms terms;
  double untold_bounce = 0.0;  // as in `NormalPlan`
};

Told shared_terms(Tile& tile, SharedModel model) {
  model.curve = tile.lights >= curve_lights;
  model.bounce = !tile.bounce.empty();
  SharedTerms terms;
  double untold_bounce = 0.0;
  for (int round = 0; round < shared_rounds; ++round) {
    if (round == 0) {
      const SharedFit all_terms = fit_shared_terms(tile, model);
      const auto gain_of = [&](bool SharedModel::*term) {
        SharedModel without = model;
        without.*term = false;
        return fit_shared_terms(tile, without).misfit - all_terms.misfit;
      };
      model.curve = model.curve && gain_of(&SharedModel::curve) > worthwhile;
      const bool told = model.bounce && is_bounce(all_terms.terms.bounce, tile) &&
                        gain_of(&SharedModel::bounce) * all_terms.freedom > significant;
      if (model.bounce && !told) untold_bounce = turn_by_bounce(tile);
      model.bounce = told;
    }
    terms = fit_shared_terms(tile, model).terms;
    terms.bounce = possible_bounce(terms.bounce, tile);
    if (!terms.curved() && terms.bounce == 0.0f) return {{}, untold_bounce};
    take_off(tile, terms);
    refit_biweight(tile);
  }
  return {std::move(terms), untold_bounce};
}

}  // namespace

NormalPlan plan_normals(const TileSource& source, Estimator estimator) {
  NormalPlan plan;
  plan.estimator = estimator;
  const Tile empty = source.tile(1, false);
  if (!empty.near) plan.pseudo_inverse = pseudo_inverse(empty);
  if (estimator == Estimator::least_squares || estimator == Estimator::lit_least_squares) {
    return plan;
  }
  Tile tile = pilot(source);
  fit_biweight(tile);
  tile.noise = noise_law(tile);
  if (estimator == Estimator::adaptive) {
    fit_biweight(tile);
    SharedModel model;
    for (const Light& light : source.stack.lights) {
      model.light_sigma.push_back(std::max(light.direction_sigma, least_light_sigma));
    }
    Told told = shared_terms(tile, std::move(model));
    plan.terms = std::move(told.terms);
    plan.untold_bounce = told.untold_bounce;
    plan.shared = plan.terms.curved() || plan.terms.bounce != 0.0f;
    if (plan.shared) tile.noise = noise_law(tile);
  }
  plan.noise = tile.noise;
  return plan;
}

}  // namespace hada
