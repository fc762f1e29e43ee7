#include "capture/faint_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include "capture/bilinear.h"
#include "core/quantile.h"

namespace hada {
namespace {

constexpr int radii = 240;
constexpr int octants = 8;

// The step across the circle on each radius: the mean over `reach` px outside minus that inside.
// Radii that leave the picture are left out.
std::vector<double> steps_across(const Grid<float>& picture, const Eigen::Vector2d& center,
                                 double radius, double reach) {
  std::vector<double> steps;
  steps.reserve(radii);
  constexpr int samples = 3;
  for (int i = 0; i < radii; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.5) / radii;
    const Eigen::Vector2d way(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d far = center + (radius + reach) * way;
    if (far.x() < 1 || far.y() < 1 || far.x() > picture.cols() - 1 ||
        far.y() > picture.rows() - 1) {
      continue;
    }
    double step = 0.0;
    for (int s = 0; s < samples; ++s) {
      const double off = reach * (s + 0.5) / samples;
      const Eigen::Vector2d outside = center + (radius + off) * way;
      const Eigen::Vector2d inside = center + (radius - off) * way;
      step +=
          bilinear(picture, outside.x(), outside.y()) - bilinear(picture, inside.x(), inside.y());
    }
    steps.push_back(step / samples);
  }
  return steps;
}

// How much of the circumference steps by about `typical` or more with its sign, less what steps
// against it: -1 to 1. Saturates, so that a bold edge counts no more than a faint one.
double coherence(const std::vector<double>& steps, double typical) {
  double sum = 0.0;
  for (const double step : steps) sum += std::tanh(step / typical);
  return sum / radii;
}

struct Step {
  double radius;
  double height;  // signed median step
};

// Concentric steps that stand out from what lies a little further in and out.
std::vector<Step> concentric_steps(const Grid<float>& picture, const Eigen::Vector2d& center,
                                   double from, double to, double reach) {
  constexpr double stride = 0.5;
  const auto apart = std::ptrdiff_t(std::max(4.0, 0.06 * from / stride));
  std::vector<double> radius, height;
  for (double r = from; r <= to + stride * double(apart); r += stride) {
    const auto steps = steps_across(picture, center, r, reach);
    radius.push_back(r);
    height.push_back(int(steps.size()) < radii / 2 ? 0.0 : median(steps));
  }
  std::vector<Step> found;
  for (std::ptrdiff_t i = 1; i + 1 < std::ptrdiff_t(height.size()); ++i) {
    if (radius[std::size_t(i)] > to) break;
    const auto size = [&](std::ptrdiff_t at) {
      const auto last = std::ptrdiff_t(height.size()) - 1;
      return std::abs(height[std::size_t(std::clamp<std::ptrdiff_t>(at, 0, last))]);
    };
    const double here = size(i);
    if (here < size(i - 1) || here <= size(i + 1)) continue;
    if (here < 1.7 * size(i + apart)) continue;
    const double sign = height[std::size_t(i)] > 0.0 ? 1.0 : -1.0;
    const auto steps = steps_across(picture, center, radius[std::size_t(i)], reach);
    if (sign * coherence(steps, here) < 0.45) continue;
    found.push_back({radius[std::size_t(i)], height[std::size_t(i)]});
  }
  return found;
}

// Where the picture rises (falls, for a negative sign) most steeply across the circle.
struct RimPoint {
  Eigen::Vector2d way;  // from the middle, unit
  double off = 0.0;     // px beyond the circle
  double rise = 0.0;    // per px
  int octant = 0;
};

std::vector<RimPoint> rim_points(const Grid<float>& picture, const Circle& circle, double sign,
                                 double window) {
  constexpr double stride = 0.25;
  const int most = int(std::lround(window / stride));
  const int turns = std::clamp(int(2.0 * std::numbers::pi * circle.radius), 90, 720);
  std::vector<RimPoint> points;
  for (int i = 0; i < turns; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.5) / turns;
    RimPoint best{{std::cos(angle), std::sin(angle)}, 0.0, 0.0, octants * i / turns};
    const Eigen::Vector2d far = circle.center + (circle.radius + window + 1.5) * best.way;
    if (far.x() < 1 || far.y() < 1 || far.x() > picture.cols() - 1 || far.y() > picture.rows() - 1)
      continue;
    const auto rise_at = [&](int step) {
      const double r = circle.radius + stride * step;
      const Eigen::Vector2d outside = circle.center + (r + 0.75) * best.way;
      const Eigen::Vector2d inside = circle.center + (r - 0.75) * best.way;
      return sign *
             (bilinear(picture, outside.x(), outside.y()) -
              bilinear(picture, inside.x(), inside.y())) /
             1.5;
    };
    double before = rise_at(-most), here = rise_at(1 - most);
    for (int step = 1 - most; step < most; ++step) {
      const double after = rise_at(step + 1);
      if (here > best.rise && here >= before && here >= after) {
        const double bend = before - 2.0 * here + after;
        best.rise = here;
        best.off = stride * (step + (bend < 0.0 ? 0.5 * (before - after) / bend : 0.0));
      }
      before = here;
      here = after;
    }
    if (best.rise > 0.0) points.push_back(best);
  }
  return points;
}

// The circle through the steepest points: a coherent step is known to a pixel or two only, for it
// saturates. Points of a faint rim count less, those of a bold one no more than the typical.
Circle through_rim(const Grid<float>& picture, const Circle& start, double sign, double window,
                   bool radius_known, int without_octant = -1) {
  Circle circle = start;
  for (const double share : {1.0, 1.0, 0.5, 0.5, 0.5, 0.5}) {
    const auto points = rim_points(picture, circle, sign, share * window);
    if (points.empty()) return start;
    std::vector<double> rises;
    for (const RimPoint& point : points) rises.push_back(point.rise);
    const double typical = quantile(std::move(rises), 0.75);
    Eigen::Matrix3d normal = 1e-9 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const RimPoint& point : points) {
      const double t = point.off / std::max(share * window, 1.0);
      if (std::abs(t) >= 1.0 || point.octant == without_octant) continue;
      const double clear = std::min(point.rise / typical, 1.0);
      const double weight = clear * clear * (1.0 - t * t) * (1.0 - t * t);
      const Eigen::Vector3d jacobian(point.way.x(), point.way.y(), radius_known ? 0.0 : 1.0);
      normal += weight * jacobian * jacobian.transpose();
      right += weight * point.off * jacobian;
    }
    const Eigen::Vector3d step = normal.ldlt().solve(right);
    circle.center += step.head<2>();
    circle.radius += step[2];
  }
  return circle;
}

}  // namespace

std::optional<Circle> faint_outline(const Grid<float>& picture, const Circle& start,
                                    std::optional<double> radius_px) {
  const double reach = std::max(1.5, 0.025 * start.radius);
  // Wide enough that a peak at a known radius has a flank on either side.
  const double margin = radius_px ? std::max(0.03 * *radius_px, 1.0) : 0.0;
  const double from = radius_px ? *radius_px - margin : 0.9 * start.radius;
  const double to = radius_px ? *radius_px + margin : 1.6 * start.radius;
  // The inner edges need not be concentric with the outline: try centres around the start.
  std::optional<Step> best;
  Eigen::Vector2d center = start.center;
  double best_score = 0.0;
  const double spread = 0.06 * start.radius;
  for (int i = -2; i <= 2; ++i) {
    for (int j = -2; j <= 2; ++j) {
      const Eigen::Vector2d at = start.center + 0.5 * spread * Eigen::Vector2d(i, j);
      for (const Step& step : concentric_steps(picture, at, from, to, reach)) {
        const auto steps = steps_across(picture, at, step.radius, reach);
        const double sign = step.height > 0.0 ? 1.0 : -1.0;
        const double share = sign * coherence(steps, std::abs(step.height));
        // Outer steps win over inner ones; among centres the most coherent.
        const double score = share + 3.0 * step.radius / start.radius;
        if (score > best_score) {
          best_score = score;
          best = step;
          center = at;
        }
      }
    }
  }
  if (!best) return std::nullopt;
  const Eigen::Vector3d place(center.x(), center.y(), radius_px.value_or(best->radius));
  const double sign = best->height > 0.0 ? 1.0 : -1.0;
  const int axes = radius_px ? 2 : 3;
  const auto settled = [&](Eigen::Vector3d at, double first_stride) {
    const auto score = [&](const Eigen::Vector3d& p) {
      return sign *
             coherence(steps_across(picture, p.head<2>(), p[2], reach), std::abs(best->height));
    };
    // Compass search: the score is flat-topped and bounded, and only its place matters.
    double now = score(at);
    for (double stride = first_stride; stride > 0.01; stride *= 0.5) {
      for (bool moved = true; moved;) {
        moved = false;
        for (int axis = 0; axis < axes; ++axis) {
          for (const double way : {-stride, stride}) {
            Eigen::Vector3d next = at;
            next[axis] += way;
            const double value = score(next);
            if (value > now + 1e-9 && next[2] < 1.7 * start.radius) {
              now = value;
              at = next;
              moved = true;
            }
          }
        }
      }
    }
    return std::pair(at, now);
  };
  const auto [found, coherent] = settled(place, 0.5 * reach);
  const Circle rough{found.head<2>(), found[2], std::clamp(coherent, 0.0, 1.0), 0.0, 0.0};
  const double window = 1.5 * reach;
  const bool known = radius_px.has_value();
  Circle outline = through_rim(picture, rough, sign, window, known);
  // How well it is known, by leaving out one octant at a time: a rim is bright on one side and hard
  // to see on the other, and neighbouring radii share their errors.
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  std::array<Eigen::Vector3d, octants> without;
  for (int octant = 0; octant < octants; ++octant) {
    const Circle other = through_rim(picture, outline, sign, window, known, octant);
    without[std::size_t(octant)] = {other.center.x(), other.center.y(), other.radius};
    mean += without[std::size_t(octant)] / octants;
  }
  double squares = 0.0;
  for (const auto& other : without) squares += (other - mean).squaredNorm();
  outline.sigma = std::sqrt((octants - 1.0) / octants * squares / axes);
  if (outline.sigma == 0.0) outline.sigma = reach;  // no rim: the coherent step is all there is
  return outline;
}

}  // namespace hada
