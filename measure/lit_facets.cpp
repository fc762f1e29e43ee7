#include "measure/lit_facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <Eigen/Geometry>

namespace hada {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int block = 16;  // pixels: roughness hangs together over less

// The mean brightness of a facet in a picture.
struct Shine {
  int facet, light;
  double brightness = 0.0, sigma = 0.0;
  Vector3d arriving = Vector3d::Zero();  // mean of direction times strength
};

// Pixels of facets that are not near a crease or the border; -1 elsewhere.
Grid<int> inner_labels(const Facets& facets) {
  const Grid<int>& label = facets.label;
  Grid<int> inner(label.rows(), label.cols(), -1);
  const int r = facets.reach_px;
  for (int row = r; row < label.rows() - r; ++row) {
    for (int col = r; col < label.cols() - r; ++col) {
      bool same = true;
      for (const int i : {-r, 0, r}) {
        for (const int j : {-r, 0, r}) same &= label(row + i, col + j) == label(row, col);
      }
      if (same) inner(row, col) = label(row, col);
    }
  }
  return inner;
}

Vector3d arriving_grey(const Light& light, const Vector3d& point) {
  Vector3d sum = Vector3d::Zero();
  for (int channel = 0; channel < 3; ++channel) sum += arriving(light, channel, point) / 3.0;
  return sum;
}

// Means of blocks, and what they scatter: the brightness of facets in one picture.
std::vector<Shine> shines_in(const LightStack& stack, int k, const Grid<int>& inner, int facets,
                             const Eigen::Vector2i& offset) {
  const int across = inner.cols() / block + 1, blocks = across * (inner.rows() / block + 1);
  const auto slot = [&](int facet, int b) {
    return std::size_t(facet) * std::size_t(blocks) + std::size_t(b);
  };
  std::vector<double> sums(slot(facets, 0), 0.0), counts(sums.size(), 0.0);
  std::vector<Vector3d> light(std::size_t(facets), Vector3d::Zero());
  std::vector<double> all(std::size_t(facets), 0.0), lit(std::size_t(facets), 0.0);
  const Image& image = stack.images[std::size_t(k)];
  const Grid<Sample>& samples = stack.samples[std::size_t(k)];
  for (int row = 0; row < inner.rows(); ++row) {
    for (int col = 0; col < inner.cols(); ++col) {
      const int f = inner(row, col), i = row + offset.y(), j = col + offset.x();
      if (f < 0 || !samples.contains(i, j)) continue;
      all[std::size_t(f)] += 1.0;
      if (samples(i, j) == Sample::saturated || samples(i, j) == Sample::highlight) continue;
      if (samples(i, j) != Sample::lit) continue;
      double grey = 0.0;
      for (const auto& plane : image.planes) grey += plane(i, j) / double(image.planes.size());
      const std::size_t at = slot(f, (row / block) * across + col / block);
      sums[at] += grey;
      counts[at] += 1.0;
      lit[std::size_t(f)] += 1.0;
      const Vector2d place = stack.extent().place(i, j);
      light[std::size_t(f)] +=
          arriving_grey(stack.lights[std::size_t(k)], {place.x(), place.y(), 0.0});
    }
  }
  std::vector<Shine> shines;
  for (int f = 0; f < facets; ++f) {
    const std::size_t n = std::size_t(f);
    // Where shadows begin, only the bright side of the roughness is seen.
    if (lit[n] < 0.98 * all[n] || lit[n] < 1.0) continue;
    double sum = 0.0, weight = 0.0, squares = 0.0, used = 0.0;
    for (int b = 0; b < blocks; ++b) {
      sum += sums[slot(f, b)];
      weight += counts[slot(f, b)];
    }
    Shine shine{f, k, sum / weight, 0.0, light[n] / lit[n]};
    for (int b = 0; b < blocks; ++b) {
      const double count = counts[slot(f, b)];
      if (count == 0.0) continue;
      const double share = count / (block * block);
      squares += share * std::pow(sums[slot(f, b)] / count - shine.brightness, 2);
      used += share;
    }
    // One part in a thousand for what is no plane and no matte paper.
    shine.sigma =
        std::hypot(std::sqrt(squares / used / std::max(used - 1.0, 1.0)), 1e-3 * shine.brightness);
    shines.push_back(shine);
  }
  return shines;
}

// What one standard deviation of each way to be wrong adds to all lights.
std::vector<LightErrorMode> error_modes(const LightStack& stack, const LitFacetOptions& options) {
  std::vector<LightErrorMode> modes = stack.light_errors;
  const std::size_t lights = stack.lights.size();
  for (std::size_t k = 0; k < lights; ++k) {
    const Light& light = stack.lights[k];
    const Vector3d way = arriving_grey(light, Vector3d::Zero());
    const auto add = [&](const Vector3d& change) {
      modes.emplace_back(lights, Vector3d::Zero());
      modes.back()[k] = change;
    };
    add(options.strength_sigma * way);
    if (!stack.light_errors.empty()) continue;
    const double sigma = light.direction_sigma > 0.0
                             ? light.direction_sigma
                             : options.light_sigma_deg * std::numbers::pi / 180.0;
    const Vector3d one = way.unitOrthogonal(), two = way.normalized().cross(one);
    add(sigma * way.norm() * one);
    add(sigma * way.norm() * two);
  }
  return modes;
}

}  // namespace

LitFacets lit_facets(const Facets& facets, const Surface& surface, const LightStack& stack,
                     const LitFacetOptions& options) {
  const int count = int(facets.facets.size()), lights = int(stack.lights.size());
  const Grid<int> inner = inner_labels(facets);
  std::vector<Shine> shines;
  std::vector<int> seen(std::size_t(count), 0);
  for (int k = 0; k < lights; ++k) {
    for (const Shine& shine : shines_in(stack, k, inner, count, surface.offset_px)) {
      shines.push_back(shine);
      ++seen[std::size_t(shine.facet)];
    }
  }
  const auto darkest = std::min_element(seen.begin(), seen.end());
  if (*darkest < 3) {
    LitFacets unknown;
    unknown.dark_facet = int(darkest - seen.begin());
    return unknown;
  }
  const auto modes = error_modes(stack, options);
  const int errors = 3 * count, albedo = errors + int(modes.size()), unknowns = albedo + 1;
  VectorXd x = VectorXd::Zero(unknowns);
  for (int f = 0; f < count; ++f) {
    // Brightness as the slopes that are known say, to begin with.
    const Vector2d& slope = facets.facets[std::size_t(f)].slope;
    const Vector3d normal = Vector3d(-slope.x(), -slope.y(), 1.0).normalized();
    double up = 0.0, down = 0.0;
    for (const Shine& shine : shines) {
      if (shine.facet != f) continue;
      up += shine.brightness * normal.dot(shine.arriving);
      down += std::pow(normal.dot(shine.arriving), 2);
    }
    x.segment<3>(3 * f) = up / down * normal;
    x[albedo] += up / down / count;
  }
  MatrixXd matrix;
  for (int step = 0; step < 10; ++step) {
    matrix = MatrixXd::Zero(unknowns, unknowns);
    VectorXd right = VectorXd::Zero(unknowns);
    const auto add = [&](const VectorXd& change, double residual) {
      matrix += change * change.transpose();
      right += residual * change;
    };
    for (const Shine& shine : shines) {
      VectorXd change = VectorXd::Zero(unknowns);
      const Vector3d normal = x.segment<3>(3 * shine.facet);
      Vector3d light = shine.arriving;
      for (std::size_t m = 0; m < modes.size(); ++m) {
        const Vector3d& error = modes[m][std::size_t(shine.light)];
        light += x[errors + int(m)] * error;
        change[errors + int(m)] = normal.dot(error) / shine.sigma;
      }
      change.segment<3>(3 * shine.facet) = light / shine.sigma;
      add(change, (shine.brightness - normal.dot(light)) / shine.sigma);
    }
    for (std::size_t m = 0; m < modes.size(); ++m) {
      VectorXd change = VectorXd::Zero(unknowns);
      change[errors + int(m)] = 1.0;
      add(change, -x[errors + int(m)]);
    }
    for (int f = 0; f < count; ++f) {
      VectorXd change = VectorXd::Zero(unknowns);
      const double sigma = options.albedo_sigma * x[albedo];
      const Vector3d normal = x.segment<3>(3 * f);
      change.segment<3>(3 * f) = normal.normalized() / sigma;
      change[albedo] = -1.0 / sigma;
      add(change, -(normal.norm() - x[albedo]) / sigma);
    }
    const VectorXd move = matrix.ldlt().solve(right);
    x += move;
    if (move.norm() < 1e-12 * x.norm()) break;
  }
  const MatrixXd covariance = matrix.ldlt().solve(MatrixXd::Identity(unknowns, unknowns));
  LitFacets result;
  MatrixXd slopes = MatrixXd::Zero(2 * count, unknowns);
  for (int f = 0; f < count; ++f) {
    const Vector3d n = x.segment<3>(3 * f);
    result.slopes.emplace_back(-n.x() / n.z(), -n.y() / n.z());
    slopes(2 * f, 3 * f) = slopes(2 * f + 1, 3 * f + 1) = -1.0 / n.z();
    slopes(2 * f, 3 * f + 2) = n.x() / (n.z() * n.z());
    slopes(2 * f + 1, 3 * f + 2) = n.y() / (n.z() * n.z());
  }
  result.covariance = slopes * covariance * slopes.transpose();
  for (int k = 0; k < lights; ++k) {
    const Vector3d was = arriving_grey(stack.lights[std::size_t(k)], Vector3d::Zero());
    Vector3d now = was;
    for (std::size_t m = 0; m < modes.size(); ++m) {
      now += x[errors + int(m)] * modes[m][std::size_t(k)];
    }
    result.turned.push_back(std::atan2(was.cross(now).norm(), was.dot(now)));
  }
  return result;
}

double fold_between(const Vector2d& one, const Vector2d& two) {
  const Vector3d a(-one.x(), -one.y(), 1.0), b(-two.x(), -two.y(), 1.0);
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double fold_sigma(const LitFacets& lit, int first, int second) {
  constexpr double step = 1e-6;
  Eigen::Vector4d change;
  for (int i = 0; i < 4; ++i) {
    Vector2d one = lit.slopes[std::size_t(first)], two = lit.slopes[std::size_t(second)];
    const double before = fold_between(one, two);
    (i < 2 ? one : two)[i % 2] += step;
    change[i] = (fold_between(one, two) - before) / step;
  }
  const std::array<int, 4> at{2 * first, 2 * first + 1, 2 * second, 2 * second + 1};
  double variance = 0.0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      variance += change[i] * change[j] * lit.covariance(at[std::size_t(i)], at[std::size_t(j)]);
    }
  }
  return std::sqrt(std::max(variance, 0.0));
}

}  // namespace hada
