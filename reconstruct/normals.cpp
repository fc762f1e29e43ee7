#include "reconstruct/normals.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel.h"
#include "reconstruct/band.h"
#include "reconstruct/box_sum.h"

namespace hada {
namespace {

constexpr double least_spread = 0.02;  // as in `Inverse`
constexpr float right_angle = float(std::numbers::pi / 2.0);
constexpr int pixels_together = 1 << 18;  // that robust_pca takes at once
// Of the turn of a normal by light that other parts of the surface threw: it was worked out for the
// shape that was found so far, as if that were matte and equally bright on all sides.
constexpr float bounce_doubt = 0.5f;

// The condition of all directions together; three that span space are what everything rests on.
double checked_condition(const LightStack& stack) {
  const std::vector<Light>& lights = stack.lights;
  if (lights.size() < 3) {
    throw Error(std::to_string(lights.size()) +
                " lights are too few for normals: add pictures until there are at least 3, lit "
                "from different sides");
  }
  const int channels = stack.images.front().channels();
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Light& light : lights) {
    if (!(light.strength.head(channels).minCoeff() > 0.0)) {
      throw Error("light of " + light.image +
                  ": its strength is not above 0 in every channel; correct it or leave it out");
    }
    const Eigen::Vector3d direction =
        (light.position ? *light.position : light.direction).normalized();
    sum += direction * direction.transpose();
  }
  const Eigen::Vector3d values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvalues();
  const double ratio = std::sqrt(std::max(values[0], 0.0) / values[2]);
  if (ratio < least_spread) {
    throw Error("the " + std::to_string(lights.size()) +
                " lights lie in one plane (smallest over largest singular value " +
                fmt::format("{:.3f}", ratio) + ", at least " + fmt::format("{:.2f}", least_spread) +
                " is needed): add a picture with a light from another side");
  }
  return 1.0 / ratio;
}

LightSums solve_all(const TileSource& source, const NormalPlan& plan, bool uncertainty,
                    NormalMaps& maps) {
  const int rows = source.stack.extent().rows;
  const int together = plan.estimator == Estimator::robust_pca
                           ? std::max(1, pixels_together / source.stack.extent().cols)
                           : 1;
  const int bands = (rows + together - 1) / together;
  std::vector<std::vector<LightSums>> sums(std::size_t(bands), std::vector<LightSums>{});
  for_slices(bands, [&](int begin, int end) {
    if (together == 1) {
      sums[std::size_t(begin)] = solve_band(source, plan, begin, end, uncertainty, maps);
      return;
    }
    for (int band = begin; band < end; ++band) {
      sums[std::size_t(band)] = solve_band(
          source, plan, band * together, std::min(rows, (band + 1) * together), uncertainty, maps);
    }
  });
  LightSums total;
  for (const auto& band : sums) {
    for (const LightSums& row : band) total.add(row);
  }
  return total;
}

double relative(double squares, double picture) {
  return picture > 0.0 ? std::sqrt(squares / picture) : 0.0;
}

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// The same solution, with the light that other parts of the surface throw left on the samples.
NormalMaps with_bounced_light(const LightStack& stack, const NormalOptions& options,
                              NormalPlan plan) {
  plan.terms.bounce = 0.0f;
  NormalMaps maps(stack, true);
  solve_all(source_of(stack, options), plan, true, maps);
  return maps;
}

// Variance of the normals, per tangent axis, that lies in the choice of their estimator: by how
// much they differ from those of another that believes other samples, beyond what noise and the
// errors of the lights do to the difference. The variance of a difference to an efficient estimator
// is the difference of the variances (J. A. Hausman, Econometrica 46, 1978). The other one knows of
// no bounced light, so it is compared with what would have been found without; what that light
// makes of the normals is in doubt on its own.
Grid<float> model_variance(const LightStack& stack, const NormalOptions& options,
                           const NormalPlan& plan, const NormalMaps& maps,
                           const Grid<float>& sample_variance) {
  NormalOptions other = options;
  other.estimator =
      options.estimator == Estimator::trimmed ? Estimator::biweight : Estimator::trimmed;
  const TileSource source = source_of(stack, other);
  NormalMaps others(stack, true);
  solve_all(source, plan_normals(source, other.estimator), true, others);
  std::optional<NormalMaps> bounced;
  if (plan.terms.bounce != 0.0f) bounced = with_bounced_light(stack, options, plan);
  const NormalMaps& alike = bounced ? *bounced : maps;
  const auto turn = [](const NormalMaps& a, const NormalMaps& b, std::size_t i) {
    return 0.5f * (a.orientation.normals[i] - b.orientation.normals[i]).squaredNorm();
  };
  // All pixels share the errors of the lights, so pooling leaves what one draw of them does: up to
  // the quantile 0.99 of chi-squared with one degree of freedom is no sign of a wrong model.
  constexpr float highest = 6.635f;
  Grid<float> count(stack.mask.rows(), stack.mask.cols());
  Grid<float> disagreement = count;
  Grid<float> doubt = count;
  for (std::size_t i = 0; i < count.size(); ++i) {
    if (!maps.orientation.mask[i] || !alike.orientation.mask[i] || !others.orientation.mask[i]) {
      continue;
    }
    const float gain = std::abs(others.noise_gain[i] - alike.noise_gain[i]);
    const float lights = std::abs(others.light_variance[i] - alike.light_variance[i]);
    const float square = turn(alike, others, i) - sample_variance[i] * gain - highest * lights;
    if (!std::isfinite(square)) continue;
    disagreement[i] = square;
    doubt[i] = bounce_doubt * bounce_doubt * turn(maps, alike, i);
    count[i] = 1.0f;
  }
  const Grid<float> pixels = box_sum(count, pool_radius_px);
  Grid<float> variance = box_sum(disagreement, pool_radius_px);
  const Grid<float> doubts = box_sum(doubt, pool_radius_px);
  for (std::size_t i = 0; i < variance.size(); ++i) {
    variance[i] = (std::max(variance[i], 0.0f) + doubts[i]) / std::max(pixels[i], 1.0f);
  }
  return variance;
}

// Variance of the normals, per tangent axis, that lies in where a pixel is: it is hardly more than
// noise on a plane, and decides where the surface turns from pixel to pixel.
float place_variance(const Orientation& found, int row, int col) {
  const auto turn = [&](int row_step, int col_step) {
    const auto inside = [&](int r, int c) { return found.mask.contains(r, c) && found.mask(r, c); };
    const bool after = inside(row + row_step, col + col_step);
    const bool before = inside(row - row_step, col - col_step);
    if (!after && !before) return 0.0f;
    const auto& to = found.normals(row + after * row_step, col + after * col_step);
    const auto& from = found.normals(row - before * row_step, col - before * col_step);
    return (to - from).squaredNorm() / float((after + before) * (after + before));
  };
  return 0.5f * place_sigma_px * place_sigma_px * (turn(0, 1) + turn(1, 0));
}

void judge_all(const LightStack& stack, const NormalOptions& options, const NormalPlan& plan,
               const LightSums& sums, const NormalMaps& maps, Orientation& found) {
  found.relighting_error = relative(sum_of(sums.used), sum_of(sums.used_picture));
  found.left_out_error = relative(sum_of(sums.left_out), sum_of(sums.picture));
  for (std::size_t k = 0; k < sums.picture.size(); ++k) {
    found.light_errors.push_back(relative(sums.left_out[k], sums.picture[k]));
  }
  found.noise = typical_noise(maps.residuals);
  const Grid<float> variance = local_variance(maps.residuals, found.noise);
  const Grid<float> model = model_variance(stack, options, plan, maps, variance);
  found.normal_sigma = Grid<float>(variance.rows(), variance.cols());
  found.albedo_sigma = found.normal_sigma;
  for_each_index(variance.rows(), [&](int row) {
    for (int col = 0; col < variance.cols(); ++col) {
      const float rho = found.rho(row, col);
      const float unexplained = unexplained_share * rho;
      const float sample = variance(row, col) + unexplained * unexplained;
      const float gain = maps.noise_gain(row, col);
      const float sigma = std::sqrt(sample * gain + maps.light_variance(row, col) +
                                    model(row, col) + place_variance(found, row, col));
      // Where the samples that are believed lie in one plane they say nothing of the normal.
      const bool known = gain > 0.0f && sigma < right_angle;
      found.normal_sigma(row, col) = known || !found.mask(row, col) ? sigma : right_angle;
      found.albedo_sigma(row, col) = rho * std::sqrt(sample * maps.albedo_gain(row, col));
    }
  });
}

}  // namespace

Orientation solve_normals(const LightStack& stack, const NormalOptions& options) {
  assert(stack.images.size() == stack.lights.size());
  assert(stack.samples.size() == stack.lights.size());
  const double condition = checked_condition(stack);
  const TileSource source = source_of(stack, options);
  const NormalPlan plan = plan_normals(source, options.estimator);
  NormalMaps maps(stack, options.uncertainty);
  const LightSums sums = solve_all(source, plan, options.uncertainty, maps);
  Orientation& found = maps.orientation;
  if (found.albedo.empty()) found.albedo = Image(found.rho);
  found.condition = condition;
  found.terms = plan.terms;
  found.untold_bounce = plan.untold_bounce;
  if (options.uncertainty) judge_all(stack, options, plan, sums, maps, found);
  return std::move(found);
}

}  // namespace hada
