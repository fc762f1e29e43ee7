#include "capture/circle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

#include "capture/bilinear.h"
#include "capture/opencv_view.h"

namespace hada {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

struct EdgePoint {
  float u, v;    // in px of the reduced picture, centre of the first pixel (0, 0)
  float du, dv;  // unit, along the gradient
};

// Thin edges: local maxima of the gradient along its own direction that stand out from the mean
// gradient of their surroundings.
std::vector<EdgePoint> edge_points(const cv::Mat& picture) {
  cv::Mat smooth, gu, gv, magnitude, around;
  cv::GaussianBlur(picture, smooth, {0, 0}, 0.8);
  cv::Scharr(smooth, gu, CV_32F, 1, 0, 1.0 / 32.0);
  cv::Scharr(smooth, gv, CV_32F, 0, 1, 1.0 / 32.0);
  cv::magnitude(gu, gv, magnitude);
  cv::blur(magnitude, around, {25, 25});
  double steepest = 0.0;
  cv::minMaxLoc(magnitude, nullptr, &steepest);
  const float least = float(1e-4 * steepest);
  constexpr float prominence = 1.5f;
  std::vector<EdgePoint> points;
  for (int row = 1; row + 1 < picture.rows; ++row) {
    for (int col = 1; col + 1 < picture.cols; ++col) {
      const float m = magnitude.at<float>(row, col);
      if (m < least || m < prominence * around.at<float>(row, col)) continue;
      const float du = gu.at<float>(row, col) / m;
      const float dv = gv.at<float>(row, col) / m;
      const int step_col = int(std::lround(du));
      const int step_row = int(std::lround(dv));
      if (m < magnitude.at<float>(row + step_row, col + step_col) ||
          m <= magnitude.at<float>(row - step_row, col - step_col)) {
        continue;
      }
      points.push_back({float(col), float(row), du, dv});
    }
  }
  return points;
}

// The share of each circle of one radius that voted for its centre: votes within two pixels, over
// the circumference.
cv::Mat support(const std::vector<EdgePoint>& points, cv::Size size, double radius) {
  cv::Mat votes = cv::Mat::zeros(size, CV_32F);
  for (const EdgePoint& p : points) {
    for (const float side : {-1.0f, 1.0f}) {
      const int col = int(std::lround(p.u + side * float(radius) * p.du));
      const int row = int(std::lround(p.v + side * float(radius) * p.dv));
      if (row >= 0 && row < size.height && col >= 0 && col < size.width) {
        votes.at<float>(row, col) += 1.0f;
      }
    }
  }
  const int reach = radius < 12.0 ? 3 : 5;
  cv::Mat gathered;
  cv::boxFilter(votes, gathered, CV_32F, {reach, reach}, {-1, -1}, false, cv::BORDER_CONSTANT);
  return gathered / (two_pi * radius);
}

Eigen::Vector2d along(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

// Derivative of the picture along a radius, smoothed over about a pixel, every half pixel.
std::vector<double> radial_slopes(const Grid<float>& picture, const Eigen::Vector2d& center,
                                  double angle, double from, double to) {
  const Eigen::Vector2d way = along(angle);
  const auto value = [&](double r) {
    const Eigen::Vector2d at = center + r * way;
    return double(bilinear(picture, at.x(), at.y()));
  };
  std::vector<double> slopes;
  for (double r = from; r <= to; r += 0.5) {
    slopes.push_back((value(r + 0.75) - value(r - 0.75) + 0.5 * (value(r + 1.5) - value(r - 1.5))) /
                     3.0);
  }
  return slopes;
}

// Where a sampled function is largest, by the parabola through the largest sample's neighbours.
double peak_place(const std::vector<double>& values, std::size_t i) {
  if (i == 0 || i + 1 >= values.size()) return double(i);
  const double a = std::abs(values[i - 1]);
  const double b = std::abs(values[i]);
  const double c = std::abs(values[i + 1]);
  const double bend = a - 2.0 * b + c;
  return double(i) + (bend < 0.0 ? 0.5 * (a - c) / bend : 0.0);
}

// The steepest point on each of the radii, if it is within the window.
std::vector<Eigen::Vector2d> steepest_points(const Grid<float>& picture, const Circle& circle,
                                             double window, int radii) {
  const double from = circle.radius * (1.0 - window);
  const double to = circle.radius * (1.0 + window);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < radii; ++i) {
    const double angle = two_pi * i / radii;
    const Eigen::Vector2d far = circle.center + to * along(angle);
    if (far.x() < 1.0 || far.y() < 1.0 || far.x() > picture.cols() - 1.0 ||
        far.y() > picture.rows() - 1.0) {
      continue;
    }
    const auto slopes = radial_slopes(picture, circle.center, angle, from, to);
    const auto steepest = std::max_element(
        slopes.begin(), slopes.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    if (*steepest == 0.0) continue;
    const double place = peak_place(slopes, std::size_t(steepest - slopes.begin()));
    points.push_back(circle.center + (from + 0.5 * place) * along(angle));
  }
  return points;
}

// Gauss-Newton on the geometric distance with Tukey's weights, whose width shrinks as it settles.
Circle fitted_circle(const std::vector<Eigen::Vector2d>& points, Circle circle, int radii) {
  for (const double width : {0.15 * circle.radius, 0.06 * circle.radius, 3.0, 1.5, 1.5, 1.5, 1.5}) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const auto& point : points) {
      const Eigen::Vector2d way = point - circle.center;
      const double distance = way.norm();
      const double residual = distance - circle.radius;
      const double t = residual / std::max(width, 1.5);
      if (std::abs(t) >= 1.0 || distance == 0.0) continue;
      const double weight = (1.0 - t * t) * (1.0 - t * t);
      const Eigen::Vector3d jacobian(way.x() / distance, way.y() / distance, 1.0);
      normal += weight * jacobian * jacobian.transpose();
      right += weight * residual * jacobian;
    }
    normal.diagonal().array() += 1e-9;
    const Eigen::Vector3d step = normal.ldlt().solve(right);
    circle.center += step.head<2>();
    circle.radius += step[2];
  }
  int agreeing = 0;
  double squares = 0.0;
  for (const auto& point : points) {
    const double residual = (point - circle.center).norm() - circle.radius;
    if (std::abs(residual) > std::max(1.0, 0.01 * circle.radius)) continue;
    ++agreeing;
    squares += residual * residual;
  }
  circle.coverage = double(agreeing) / radii;
  circle.scatter = agreeing > 0 ? std::sqrt(squares / agreeing) : 0.0;
  return circle;
}

}  // namespace

std::vector<Circle> circle_candidates(const Grid<float>& picture, const CircleSearch& search) {
  const int longer = std::max(picture.rows(), picture.cols());
  const int shorter = std::min(picture.rows(), picture.cols());
  // A sphere of the smallest radius must keep a few pixels.
  const double scale = std::clamp(
      std::max(search.longest_side / longer, 5.0 / search.smallest_radius), 1.0 / longer, 1.0);
  cv::Mat reduced;
  if (scale < 1.0) {
    cv::resize(view(picture), reduced, {}, scale, scale, cv::INTER_AREA);
  } else {
    view(picture).copyTo(reduced);
  }
  const auto points = edge_points(reduced);

  const double smallest = std::max(4.0, search.smallest_radius * scale);
  const double largest = scale * std::min(search.largest_radius, 0.5 * shorter);
  std::vector<Circle> found;
  cv::Mat before, here, after;
  for (double radius = smallest; radius <= largest; radius += std::max(1.0, 0.02 * radius)) {
    const cv::Mat votes = support(points, reduced.size(), radius);
    cv::Mat highest;
    cv::dilate(votes, highest, cv::Mat::ones(5, 5, CV_8U));
    for (int row = 0; row < votes.rows; ++row) {
      for (int col = 0; col < votes.cols; ++col) {
        const float share = votes.at<float>(row, col);
        if (share < 0.3f || share < highest.at<float>(row, col)) continue;
        found.push_back({Eigen::Vector2d((col + 0.5) / scale, (row + 0.5) / scale), radius / scale,
                         share, 0.0, 0.0});
      }
    }
  }
  // Small circles gather votes by chance: their share is worth less.
  const auto worth = [](const Circle& c) { return c.coverage * std::pow(c.radius, 0.25); };
  std::stable_sort(found.begin(), found.end(),
                   [&](const Circle& a, const Circle& b) { return worth(a) > worth(b); });
  std::vector<Circle> kept;
  for (const Circle& circle : found) {
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const Circle& other) {
      return (circle.center - other.center).norm() + std::abs(circle.radius - other.radius) <
             0.12 * other.radius + 2.0 / scale;
    });
    if (!known) kept.push_back(circle);
    if (int(kept.size()) >= search.most) break;
  }
  return kept;
}

Circle refined(const Grid<float>& picture, const Circle& start, double window) {
  const int radii = std::clamp(int(two_pi * start.radius), 90, 720);
  Circle circle = start;
  for (const double share : {window, 0.5 * window, std::max(3.0 / start.radius, 0.25 * window)}) {
    const auto points = steepest_points(picture, circle, share, radii);
    if (int(points.size()) < radii / 4) return {start.center, start.radius, 0.0, 0.0, 0.0};
    const Circle next = fitted_circle(points, circle, radii);
    const bool sane = std::isfinite(next.radius) && next.radius > 0.5 * start.radius &&
                      next.radius < 2.0 * start.radius &&
                      (next.center - start.center).norm() < start.radius;
    if (!sane) return {start.center, start.radius, 0.0, 0.0, 0.0};
    circle = next;
  }
  if (circle.coverage < 0.25) circle.coverage = 0.0;
  return circle;
}

std::optional<Circle> disc_of(const Mask& mask) {
  if (mask.empty()) return std::nullopt;
  double count = 0.0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      count += 1.0;
      sum += Eigen::Vector2d(col + 0.5, row + 0.5);
    }
  }
  if (count == 0.0) return std::nullopt;
  Circle disc;
  disc.center = sum / count;
  disc.radius = std::sqrt(count / std::numbers::pi);
  double inside = 0.0;
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      const Eigen::Vector2d at(col + 0.5, row + 0.5);
      inside += mask(row, col) && (at - disc.center).norm() <= disc.radius;
    }
  }
  if (inside < 0.97 * count) return std::nullopt;
  disc.coverage = 1.0;
  disc.scatter = 0.5;
  return disc;
}

}  // namespace hada
