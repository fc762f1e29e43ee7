#include "reconstruct/normals.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel.h"
#include "reconstruct/noise.h"

namespace hada {
namespace {

// The smallest singular value of the directions over the largest, below which they count as lying
// in one plane: there a noise of 1 % of the albedo turns the normal by about half a radian.
constexpr double least_spread = 0.02;
constexpr double least_z = 0.02;  // of a normal; steeper than 88.9 degrees a slope means nothing

using Directions = std::vector<Eigen::Vector3d>;  // of the lights, at one place
using Bytes = std::vector<std::uint8_t>;

double spread(const Eigen::Matrix3d& normal_matrix) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  const auto values = solver.computeDirect(normal_matrix, Eigen::EigenvaluesOnly).eigenvalues();
  return values[2] > 0.0 ? std::sqrt(std::max(values[0], 0.0) / values[2]) : 0.0;
}

// What arrives at one place from every light, its strength apart.
struct Arrival {
  Directions direction;
  std::vector<double> falloff;  // 1 for a distant light

  Arrival(const std::vector<Light>& lights, const Eigen::Vector2d& place)
      : direction(lights.size()), falloff(lights.size()) {
    const Eigen::Vector3d point(place.x(), place.y(), 0.0);
    for (std::size_t k = 0; k < lights.size(); ++k) {
      Light unit = lights[k];
      unit.strength.setOnes();
      const Eigen::Vector3d light = arriving(unit, 0, point);
      falloff[k] = light.norm();
      direction[k] = light / falloff[k];
    }
  }
};

// The least-squares system of the lights that are lit at a pixel.
struct System {
  Eigen::Matrix3d inverse;  // of N^T N
  bool solvable = false;

  System(const Directions& direction, const std::uint8_t* lit) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    int count = 0;
    for (std::size_t k = 0; k < direction.size(); ++k) {
      if (!lit[k]) continue;
      sum += direction[k] * direction[k].transpose();
      ++count;
    }
    solvable = count >= 3 && spread(sum) >= least_spread;
    if (solvable) inverse = sum.inverse();
  }
};

// The samples of one row, those of a pixel side by side.
struct RowSamples {
  std::vector<float> grey;  // strength divided out
  Bytes lit;

  RowSamples(const LightStack& stack, Estimator estimator, int row) {
    const bool all_count = estimator == Estimator::least_squares;
    const std::size_t lights = stack.lights.size();
    const std::size_t cols = std::size_t(stack.extent().cols);
    grey.assign(lights * cols, 0.0f);
    lit.assign(lights * cols, 0);
    for (std::size_t k = 0; k < lights; ++k) {
      const Image& image = stack.images[k];
      for (int channel = 0; channel < image.channels(); ++channel) {
        const float weight = image.channels() == 1 ? 1.0f : luminance_weight[channel];
        const float scale = weight / float(stack.lights[k].strength[channel]);
        const auto values = image.planes[std::size_t(channel)].row(row);
        for (std::size_t col = 0; col < cols; ++col) grey[col * lights + k] += scale * values[col];
      }
      const auto samples = stack.samples[k].row(row);
      for (std::size_t col = 0; col < cols; ++col) {
        lit[col * lights + k] = all_count || samples[col] == Sample::lit;
      }
    }
  }
};

// One pixel's answer, and how sure it is.
struct Solution {
  Eigen::Vector3d normal;
  double squares = 0.0;         // of the residuals, less the part that the lights explain
  double freedom = -3.0;        // lit samples minus the three unknowns
  double noise_gain = 0.0;      // variance of the normal for a sample variance of 1
  double light_variance = 0.0;  // variance of the normal that errors of the lights bring
};

// The mean variance along the two tangent axes of `normal` where rho n has this covariance.
double tangent_variance(const Eigen::Matrix3d& covariance, const Eigen::Vector3d& normal,
                        double rho) {
  return (covariance.trace() - normal.dot(covariance * normal)) / (2.0 * rho * rho);
}

// rho n = N^+ I; nothing where the normal looks away from the camera.
std::optional<Solution> solve(const std::vector<Light>& lights, const Arrival& arrival,
                              const System& system, const std::uint8_t* lit, const float* grey) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < lights.size(); ++k) {
    if (lit[k]) sum += grey[k] / arrival.falloff[k] * arrival.direction[k];
  }
  const Eigen::Vector3d scaled_normal = system.inverse * sum;
  const double rho = scaled_normal.norm();
  if (!(scaled_normal.z() > least_z * rho)) return std::nullopt;
  Solution solution{.normal = scaled_normal / rho};
  for (std::size_t k = 0; k < lights.size(); ++k) {
    if (!lit[k]) continue;
    const double cosine = solution.normal.dot(arrival.direction[k]);
    const double residual = grey[k] / arrival.falloff[k] - rho * cosine;
    solution.squares += residual * residual;
    solution.freedom += 1.0;
    const double tilt = lights[k].direction_sigma;
    if (tilt == 0.0) continue;
    // A light turned by dl changes its sample by rho n.dl, which N^+ carries on to the normal.
    const double variance = rho * rho * tilt * tilt * std::max(0.0, 1.0 - cosine * cosine);
    const Eigen::Vector3d gain = system.inverse * arrival.direction[k];
    solution.squares -= variance * (1.0 - gain.dot(arrival.direction[k]));
    solution.light_variance +=
        variance * tangent_variance(gain * gain.transpose(), solution.normal, rho);
  }
  solution.noise_gain = tangent_variance(system.inverse, solution.normal, rho);
  return solution;
}

// Sums of squares over the lit samples; formed row by row and added up in row order.
struct Relighting {
  double picture = 0.0;
  double error = 0.0;  // picture minus prediction
};

// The rho of I = rho s max(0, n.l) in one channel of one pixel, by least squares.
float solve_albedo(const LightStack& stack, int channel, int row, int col, const Arrival& arrival,
                   const Eigen::Vector3d& normal, const std::uint8_t* lit, Relighting& relighting) {
  double shading_squares = 0.0;
  double product = 0.0;
  double picture = 0.0;
  for (std::size_t k = 0; k < stack.lights.size(); ++k) {
    if (!lit[k]) continue;
    const double shading = stack.lights[k].strength[channel] * arrival.falloff[k] *
                           std::max(0.0, normal.dot(arrival.direction[k]));
    const double value = stack.images[k].planes[std::size_t(channel)](row, col);
    shading_squares += shading * shading;
    product += shading * value;
    picture += value * value;
  }
  const double rho = shading_squares > 0.0 ? product / shading_squares : 0.0;
  relighting.picture += picture;
  relighting.error += std::max(0.0, picture - rho * product);
  return float(rho);
}

// Everything that is found pixel by pixel, before the noise is known.
struct Maps {
  Orientation orientation;
  Residuals residuals;
  Grid<float> noise_gain;
  Grid<float> light_variance;

  explicit Maps(const LightStack& stack) {
    const int rows = stack.extent().rows;
    const int cols = stack.extent().cols;
    orientation.normals = NormalMap(rows, cols, Eigen::Vector3f::UnitZ());
    orientation.albedo = Image(rows, cols, stack.images.front().channels());
    orientation.mask = stack.mask;
    for (auto* map : {&residuals.squares, &residuals.freedom, &noise_gain, &light_variance}) {
      *map = Grid<float>(rows, cols);
    }
  }
};

Relighting solve_row(const LightStack& stack, Estimator estimator, bool near, int row, Maps& maps) {
  const RowSamples samples(stack, estimator, row);
  const std::size_t count = stack.lights.size();
  Relighting relighting;
  Arrival arrival(stack.lights, Eigen::Vector2d::Zero());
  Bytes known(count, 0);  // what was lit for the present system: neighbours are mostly alike
  System system(arrival.direction, known.data());
  for (int col = 0; col < stack.extent().cols; ++col) {
    auto& valid = maps.orientation.mask(row, col);
    if (!valid) continue;
    const std::uint8_t* lit = samples.lit.data() + std::size_t(col) * count;
    const float* grey = samples.grey.data() + std::size_t(col) * count;
    if (near) arrival = Arrival(stack.lights, stack.extent().place(row, col));
    if (near || !std::equal(known.begin(), known.end(), lit)) {
      std::copy(lit, lit + count, known.begin());
      system = System(arrival.direction, lit);
    }
    const auto found = system.solvable ? solve(stack.lights, arrival, system, lit, grey)
                                       : std::optional<Solution>();
    valid = found.has_value();
    if (!found) continue;
    maps.orientation.normals(row, col) = found->normal.cast<float>();
    maps.residuals.squares(row, col) = float(found->squares);
    maps.residuals.freedom(row, col) = float(found->freedom);
    maps.noise_gain(row, col) = float(found->noise_gain);
    maps.light_variance(row, col) = float(found->light_variance);
    for (int channel = 0; channel < maps.orientation.albedo.channels(); ++channel) {
      maps.orientation.albedo.planes[std::size_t(channel)](row, col) =
          solve_albedo(stack, channel, row, col, arrival, found->normal, lit, relighting);
    }
  }
  return relighting;
}

// The condition of all directions together; three that span space are what everything rests on.
double checked_condition(const LightStack& stack) {
  const std::vector<Light>& lights = stack.lights;
  if (lights.size() < 3) {
    throw Error(std::to_string(lights.size()) +
                " lights are too few for normals: add pictures until there are at least 3, lit "
                "from different sides");
  }
  const int channels = stack.images.front().channels();
  for (const Light& light : lights) {
    if (!(light.strength.head(channels).minCoeff() > 0.0)) {
      throw Error("light of " + light.image +
                  ": its strength is not above 0 in every channel; correct it or leave it out");
    }
  }
  const Directions directions = Arrival(lights, Eigen::Vector2d::Zero()).direction;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const auto& direction : directions) sum += direction * direction.transpose();
  const double ratio = spread(sum);
  if (ratio < least_spread) {
    throw Error("the " + std::to_string(lights.size()) +
                " lights lie in one plane (smallest over largest singular value " +
                fmt::format("{:.3f}", ratio) + ", at least " + fmt::format("{:.2f}", least_spread) +
                " is needed): add a picture with a light from another side");
  }
  return 1.0 / ratio;
}

}  // namespace

std::string_view name_of(Estimator estimator) {
  return estimator == Estimator::least_squares ? "least-squares" : "lit-least-squares";
}

Orientation least_squares_normals(const LightStack& stack, Estimator estimator) {
  assert(stack.images.size() == stack.lights.size());
  assert(stack.samples.size() == stack.lights.size());
  const double condition = checked_condition(stack);
  const bool near = std::any_of(stack.lights.begin(), stack.lights.end(),
                                [](const Light& light) { return light.position.has_value(); });
  Maps maps(stack);
  std::vector<Relighting> rows(std::size_t(stack.extent().rows));
  for_each_index(stack.extent().rows, [&](int row) {
    rows[std::size_t(row)] = solve_row(stack, estimator, near, row, maps);
  });
  Relighting total;
  for (const Relighting& row : rows) {
    total.picture += row.picture;
    total.error += row.error;
  }

  Orientation& result = maps.orientation;
  result.condition = condition;
  result.relighting_error = total.picture > 0.0 ? std::sqrt(total.error / total.picture) : 0.0;
  result.noise = typical_noise(maps.residuals);
  result.normal_sigma = local_variance(maps.residuals, result.noise);
  for (std::size_t i = 0; i < result.normal_sigma.size(); ++i) {
    result.normal_sigma[i] =
        std::sqrt(result.normal_sigma[i] * maps.noise_gain[i] + maps.light_variance[i]);
  }
  return std::move(result);
}

}  // namespace hada
