#include "app/overlap.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "core/quantile.h"
#include "measure/measured_map.h"

namespace hada {
namespace {

// Takes the best plane off the difference; what was levelled differently is not an error.
void remove_plane(Grid<float>& difference, const Mask& mask) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      const Eigen::Vector3d basis(1.0, double(col) / mask.cols(), double(row) / mask.rows());
      normal += basis * basis.transpose();
      right += basis * double(difference(row, col));
    }
  }
  const Eigen::Vector3d plane = normal.completeOrthogonalDecomposition().solve(right);
  for (int row = 0; row < mask.rows(); ++row) {
    for (int col = 0; col < mask.cols(); ++col) {
      if (!mask(row, col)) continue;
      difference(row, col) -=
          float(plane.x() + plane.y() * col / mask.cols() + plane.z() * row / mask.rows());
    }
  }
}

void compare_heights(Overlap& o, const Surface& first, const Surface& second) {
  const auto a = crop(measured_map(first), o.first_px.y(), o.first_px.x(), o.rows, o.cols);
  const auto b = crop(measured_map(second), o.second_px.y(), o.second_px.x(), o.rows, o.cols);
  o.difference = Grid<float>(o.rows, o.cols);
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < o.mask.size(); ++i) {
    if (!o.mask[i]) continue;
    o.difference[i] = a[i] - b[i];
    sum += b[i];
    squares += double(b[i]) * b[i];
  }
  remove_plane(o.difference, o.mask);
  double residual = 0.0;
  for (std::size_t i = 0; i < o.mask.size(); ++i) {
    if (o.mask[i]) residual += double(o.difference[i]) * o.difference[i];
  }
  const double count = double(o.pixels);
  o.height_rmse = std::sqrt(residual / count);
  o.height_std = std::sqrt(std::max(0.0, squares / count - sum / count * (sum / count)));
}

void compare_normals(Overlap& o, const Surface& first, const Surface& second) {
  o.has_normals = !first.normals.empty() && !second.normals.empty();
  if (!o.has_normals) return;
  const auto a = crop(first.normals, o.first_px.y(), o.first_px.x(), o.rows, o.cols);
  const auto b = crop(second.normals, o.second_px.y(), o.second_px.x(), o.rows, o.cols);
  std::vector<double> angles;
  double sum = 0.0;
  for (std::size_t i = 0; i < o.mask.size(); ++i) {
    if (!o.mask[i]) continue;
    const Eigen::Vector3d m = a[i].cast<double>();
    const Eigen::Vector3d n = b[i].cast<double>();
    angles.push_back(std::atan2(m.cross(n).norm(), m.dot(n)));
    sum += angles.back();
  }
  o.normal_mean = sum / double(angles.size());
  o.normal_median = median(std::move(angles));
}

}  // namespace

std::optional<Overlap> overlap(const Surface& first, const Surface& second) {
  const Extent& a = first.extent;
  const Extent& b = second.extent;
  if (std::abs(a.pitch - b.pitch) > 1e-6 * b.pitch) return {};
  const bool is_same_size = a.rows == b.rows && a.cols == b.cols;
  const bool is_placed =
      first.offset_px != Eigen::Vector2i(0, 0) && second.offset_px != Eigen::Vector2i(0, 0);
  const Eigen::Vector2i shift = is_same_size && !is_placed
                                    ? Eigen::Vector2i(0, 0)
                                    : Eigen::Vector2i(first.offset_px - second.offset_px);
  Overlap o;
  o.second_px = shift.cwiseMax(0);
  o.first_px = (-shift).cwiseMax(0);
  o.rows = std::min(a.rows - o.first_px.y(), b.rows - o.second_px.y());
  o.cols = std::min(a.cols - o.first_px.x(), b.cols - o.second_px.x());
  if (o.rows <= 0 || o.cols <= 0) return {};
  o.mask = crop(first.mask, o.first_px.y(), o.first_px.x(), o.rows, o.cols);
  const auto other = crop(second.mask, o.second_px.y(), o.second_px.x(), o.rows, o.cols);
  for (std::size_t i = 0; i < o.mask.size(); ++i) {
    o.mask[i] = o.mask[i] && other[i] ? 1 : 0;
    o.pixels += o.mask[i];
  }
  constexpr long fewest = 16;
  if (o.pixels < fewest) return {};
  compare_heights(o, first, second);
  compare_normals(o, first, second);
  return o;
}

}  // namespace hada
