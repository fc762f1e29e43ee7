#include "measure/crease_edge.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

#include "core/quantile.h"

namespace hada {
namespace {

using Eigen::Vector2d;

struct Equations {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double cost = 0.0;
  double squares = 0.0;
};

// Unknowns: turn of the normal, offset, logarithm of the width; lengths about `centre`.
Equations equations(const std::vector<StepSample>& samples, const CreaseEdge& edge,
                    const Vector2d& centre, double huber) {
  Equations all;
  const Vector2d along(-edge.normal.y(), edge.normal.x());
  for (const StepSample& sample : samples) {
    const double across = edge.normal.dot(sample.place) - edge.offset;
    const double z = across / edge.width;
    const double expected = 0.5 * std::erfc(-z / std::numbers::sqrt2);
    const double slope = std::exp(-0.5 * z * z) / (std::sqrt(2.0 * std::numbers::pi) * edge.width);
    const double residual = sample.passed - expected;
    const double weight = std::min(1.0, huber / std::max(std::abs(residual), 1e-300));
    const Eigen::Vector3d change(slope * along.dot(sample.place - centre), -slope, -slope * across);
    all.matrix += weight * change * change.transpose();
    all.right += weight * residual * change;
    all.cost += weight * residual * residual * (weight < 1.0 ? 2.0 / weight - 1.0 : 1.0);
    all.squares += weight * residual * residual;
  }
  return all;
}

CreaseEdge moved(const CreaseEdge& edge, const Eigen::Vector3d& step, const Vector2d& centre) {
  CreaseEdge next = edge;
  const double c = std::cos(step[0]), s = std::sin(step[0]);
  next.normal = Vector2d(c * edge.normal.x() - s * edge.normal.y(),
                         s * edge.normal.x() + c * edge.normal.y());
  // The line turns about its point nearest to the centre.
  const double at_centre = edge.offset - edge.normal.dot(centre);
  next.offset = next.normal.dot(centre) + at_centre + step[1];
  next.width = edge.width * std::exp(std::clamp(step[2], -1.0, 1.0));
  return next;
}

}  // namespace

CreaseEdge fitted_edge(const std::vector<StepSample>& samples, const CreaseEdge& start) {
  if (samples.size() < 8) return start;
  Vector2d centre = Vector2d::Zero();
  for (const StepSample& sample : samples) centre += sample.place / double(samples.size());
  std::vector<double> off;
  for (const StepSample& sample : samples) {
    const double z = (start.normal.dot(sample.place) - start.offset) / start.width;
    off.push_back(std::abs(sample.passed - 0.5 * std::erfc(-z / std::numbers::sqrt2)));
  }
  const double huber = std::max(3.0 * 1.4826 * median(off), 0.02);
  CreaseEdge edge = start;
  const double narrowest = 0.1 * start.width, widest = 20.0 * start.width;
  double damping = 1e-3;
  Equations now = equations(samples, edge, centre, huber);
  for (int step = 0; step < 60; ++step) {
    Eigen::Matrix3d matrix = now.matrix;
    matrix.diagonal() *= 1.0 + damping;
    matrix.diagonal().array() += 1e-12 * now.matrix.trace() + 1e-300;
    const Eigen::Vector3d change = matrix.ldlt().solve(now.right);
    CreaseEdge next = moved(edge, change, centre);
    next.width = std::clamp(next.width, narrowest, widest);
    const Equations then = equations(samples, next, centre, huber);
    if (!(then.cost <= now.cost)) {
      damping *= 10.0;
      if (damping > 1e8) break;
      continue;
    }
    const bool done = now.cost - then.cost < 1e-12 * now.cost;
    edge = next;
    now = then;
    damping = std::max(0.1 * damping, 1e-12);
    if (done) break;
  }
  const double variance = now.squares / double(samples.size() - 3);
  const Eigen::Matrix3d inverse =
      (now.matrix + 1e-12 * now.matrix.trace() * Eigen::Matrix3d::Identity()).inverse();
  const auto sigma = [&](int i) { return std::sqrt(std::max(variance * inverse(i, i), 0.0)); };
  edge.turn_sigma = sigma(0);
  edge.offset_sigma = sigma(1);
  edge.width_sigma = edge.width * sigma(2);
  return edge;
}

}  // namespace hada
