#include "measure/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/error.h"

namespace hada {
namespace {

using Eigen::Vector2d;

struct Side {
  Vector2d place{0.0, 0.0};  // in pixels, v down
  Vector2d way{1.0, 0.0};
};

// The straight line through the middle of a run of contour pixels: ends are round.
Side fitted_side(const std::vector<Vector2d>& points) {
  const std::size_t skip = std::min<std::size_t>(points.size() / 6, 12);
  Side side;
  double count = 0.0;
  for (std::size_t i = skip; i + skip < points.size(); ++i, ++count) side.place += points[i];
  side.place /= count;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (std::size_t i = skip; i + skip < points.size(); ++i) {
    spread += (points[i] - side.place) * (points[i] - side.place).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  side.way = axes.eigenvectors().col(1);
  if (side.way.dot(points.back() - points.front()) < 0.0) side.way = -side.way;
  return side;
}

Vector2d meeting(const Side& a, const Side& b, const Vector2d& otherwise) {
  const double sine = a.way.x() * b.way.y() - a.way.y() * b.way.x();
  if (std::abs(sine) < 0.05) return otherwise;
  const Vector2d gap = b.place - a.place;
  return a.place + a.way * ((gap.x() * b.way.y() - gap.y() * b.way.x()) / sine);
}

}  // namespace

std::vector<Vector2d> outline_of(const Mask& mask, const Extent& extent) {
  cv::Mat binary(mask.rows() + 2, mask.cols() + 2, CV_8U, cv::Scalar(0));
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (mask(row, col)) binary.at<std::uint8_t>(row + 1, col + 1) = 255;
    }
  }
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(binary, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  if (contours.empty()) throw Error("the mask is empty; a sheet must be seen");
  const auto& contour = *std::max_element(
      contours.begin(), contours.end(),
      [](const auto& a, const auto& b) { return cv::contourArea(a) < cv::contourArea(b); });
  const double size = std::max(mask.rows(), mask.cols());
  std::vector<cv::Point> rough;
  cv::approxPolyDP(contour, rough, std::max(2.0, 0.006 * size), true);
  if (rough.size() < 3) throw Error("the sheet has no outline with corners; check its mask");
  std::vector<Side> sides;
  std::vector<Vector2d> rough_corners;
  const auto index_of = [&](const cv::Point& p) {
    return std::size_t(std::find(contour.begin(), contour.end(), p) - contour.begin());
  };
  const double turn = cv::contourArea(rough, true) > 0.0 ? 1.0 : -1.0;
  for (std::size_t k = 0; k < rough.size(); ++k) {
    const std::size_t begin = index_of(rough[k]);
    const std::size_t end = index_of(rough[(k + 1) % rough.size()]);
    std::vector<Vector2d> run;
    for (std::size_t i = begin;; i = (i + 1) % contour.size()) {
      run.emplace_back(contour[i].x - 1.0, contour[i].y - 1.0);
      if (i == end) break;
    }
    Side side = fitted_side(run);
    // The contour runs through the outermost pixels; the sheet ends half a pixel further out.
    const Vector2d outward = turn * Vector2d(side.way.y(), -side.way.x());
    side.place += 0.5 * outward * (std::abs(outward.x()) + std::abs(outward.y()));
    sides.push_back(side);
    rough_corners.push_back(run.front());
  }
  std::vector<Vector2d> corners;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const Side& before = sides[(k + sides.size() - 1) % sides.size()];
    const Vector2d p = meeting(before, sides[k], rough_corners[k]);
    corners.push_back(extent.place(p.y(), p.x()));
  }
  double twice = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector2d &a = corners[k], &b = corners[(k + 1) % corners.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  if (twice < 0.0) std::reverse(corners.begin(), corners.end());
  return corners;
}

}  // namespace hada
