#include "fit/unrolled.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.h"
#include "core/parallel.h"

namespace hada {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
constexpr int fewest_rays = 3;      // that a median is taken of
constexpr double joined_px = 16.0;  // arc that a sector sees at least
constexpr int most_joined = 8;      // parts of a turn: no more than one on each side

/// `value_at`, for the loops of this file.
inline float sampled(const Grid<float>& map, const Mask& mask, const Eigen::Vector2d& pixel) {
  if (!(pixel.x() >= 0.0) || !(pixel.y() >= 0.0)) return nothing;
  const int row = int(pixel.x()), col = int(pixel.y());  // cheaper than floor
  if (row + 1 >= map.rows() || col + 1 >= map.cols()) return nothing;
  if (!mask(row, col) || !mask(row, col + 1) || !mask(row + 1, col) || !mask(row + 1, col + 1))
    return nothing;
  const float v = float(pixel.x() - row), u = float(pixel.y() - col);
  return (1.0f - v) * ((1.0f - u) * map(row, col) + u * map(row, col + 1)) +
         v * ((1.0f - u) * map(row + 1, col) + u * map(row + 1, col + 1));
}

/// The radii of all columns in one direction, exact at every eighth of them.
std::vector<double> radii_along(const Unrolled& flat, int cols, const GrowthFrame& frame,
                                double theta) {
  constexpr int stride = 8;
  std::vector<double> radii(std::size_t(cols + stride), 0.0);
  const GrowthRay ray(frame.lobes, theta);
  double before = ray.radius_at(flat.rho(0));
  for (int col = 0; col < cols; col += stride) {
    const double rho = flat.rho(col + stride);
    const double near = flat.rho(col) > 0.0 ? before * rho / flat.rho(col) : rho;
    const double after = ray.radius_at(rho, near);
    for (int k = 0; k < stride; ++k)
      radii[std::size_t(col + k)] = before + (after - before) * k / stride;
    before = after;
  }
  return radii;
}

/// The part of the plane that the wood takes, as seen from the pith.
struct View {
  double nearest = HUGE_VAL, farthest = 0.0;  // effective radii
  double low = 0.0, high = turn;              // directions
};

/// About a hundred places along `count`, the first and the last among them.
std::vector<int> spread_over(int count) {
  std::vector<int> places;
  for (int i = 0; i < count - 1; i += std::max(1, count / 100)) places.push_back(i);
  places.push_back(count - 1);
  return places;
}

View view_of(const Mask& mask, const Extent& extent, const GrowthFrame& frame) {
  View view;
  const Eigen::Vector2d pith_px = extent.pixel(frame.pith);
  const double middle = std::atan2(-frame.pith.y(), -frame.pith.x());
  double least = 0.0, most = 0.0;
  for (const int row : spread_over(extent.rows)) {
    for (const int col : spread_over(extent.cols)) {
      if (!mask(row, col)) continue;
      const Eigen::Vector2d place = extent.place(row, col);
      const double rho = frame.rho_of(place);
      view.nearest = std::min(view.nearest, rho);
      view.farthest = std::max(view.farthest, rho);
      const Eigen::Vector2d arm = place - frame.pith;
      const double angle = std::remainder(std::atan2(arm.y(), arm.x()) - middle, turn);
      least = std::min(least, angle);
      most = std::max(most, angle);
    }
  }
  const int row = int(std::lround(pith_px.x())), col = int(std::lround(pith_px.y()));
  if (mask.contains(row, col)) {
    view.nearest = 0.0;
  } else {
    view.low = middle + least;
    view.high = middle + most;
  }
  return view;
}

/// Near the pith a sector is a pixel or two wide and as noisy as these: there, the mean of
/// neighbours.
void join_narrow_sectors(Unrolled& flat) {
  const int sectors = flat.values.rows();
  const auto at = [&](const std::vector<float>& column, int s) {
    if (flat.whole_turn) return column[std::size_t((s + sectors) % sectors)];
    return s < 0 || s >= sectors ? nothing : column[std::size_t(s)];
  };
  std::vector<float> column(static_cast<std::size_t>(sectors));
  for (int col = 0; col < flat.values.cols(); ++col) {
    const int reach = flat.joined_at(flat.rho(col));
    if (reach < 1) return;
    for (int s = 0; s < sectors; ++s) column[std::size_t(s)] = flat.values(s, col);
    for (int s = 0; s < sectors; ++s) {
      float sum = 0.0f, count = 0.0f;
      for (int k = -reach; k <= reach; ++k) {
        const float value = at(column, s + k);
        if (value == value) {
          sum += value;
          count += 1.0f;
        }
      }
      if (count > 0.0f && column[std::size_t(s)] == column[std::size_t(s)])
        flat.values(s, col) = sum / count;
    }
  }
}

}  // namespace

int Unrolled::joined_at(double rho) const {
  const double arc = std::max(rho * sector_rad, 1e-3 * joined);
  if (arc >= joined) return 0;
  return std::min(int(std::lround(0.5 * (joined / arc - 1.0))), values.rows() / most_joined);
}

float value_at(const Grid<float>& map, const Mask& mask, const Eigen::Vector2d& pixel) {
  return sampled(map, mask, pixel);
}

Unrolled unrolled(const Grid<float>& map, const Mask& mask, const Extent& extent,
                  const GrowthFrame& frame, const UnrollOptions& options) {
  const View view = view_of(mask, extent, frame);
  if (!(view.farthest > view.nearest) || !std::isfinite(view.farthest)) {
    throw Error("wood: the rings do not lie around any place that could be a pith");
  }
  Unrolled flat;
  flat.step = options.step_px * extent.pitch;
  flat.first = view.nearest;
  flat.whole_turn = view.high - view.low >= turn;
  const double rim_px = view.farthest / extent.pitch * (view.high - view.low);
  const int sectors = std::clamp(int(rim_px / options.sector_px), 12, 720);
  flat.sector_rad = (view.high - view.low) / sectors;
  const int rays = std::clamp(int(flat.sector_rad * view.farthest / extent.pitch / options.ray_px),
                              fewest_rays, 64);
  const int cols = int((view.farthest - view.nearest) / flat.step) + 1;
  flat.values = Grid<float>(sectors, cols, nothing);
  for (int s = 0; s < sectors; ++s) flat.theta.push_back(view.low + (s + 0.5) * flat.sector_rad);
  const Eigen::Vector2d pith_px = extent.pixel(frame.pith);
  const auto lay = [&](int s, std::vector<std::array<float, 64>>& seen, std::vector<int>& count) {
    std::fill(count.begin(), count.end(), 0);
    for (int ray = 0; ray < rays; ++ray) {
      const double theta =
          flat.theta[std::size_t(s)] + ((ray + 0.5) / rays - 0.5) * flat.sector_rad;
      // Pixels lie along a line, so that the frame of the picture is asked but once.
      const Eigen::Vector2d direction =
          extent.pixel(frame.pith + Eigen::Vector2d(std::cos(theta), std::sin(theta))) - pith_px;
      const auto radii = radii_along(flat, cols, frame, theta);
      for (int col = 0; col < cols; ++col) {
        const float value = sampled(map, mask, pith_px + radii[std::size_t(col)] * direction);
        auto& n = count[std::size_t(col)];
        if (value == value) seen[std::size_t(col)][std::size_t(n++)] = value;
      }
    }
    for (int col = 0; col < cols; ++col) {
      const int n = count[std::size_t(col)];
      if (n < fewest_rays) continue;
      const auto begin = seen[std::size_t(col)].begin();
      std::nth_element(begin, begin + n / 2, begin + n);
      flat.values(s, col) = *(begin + n / 2);
    }
  };
  for_slices(sectors, [&](int begin, int end) {
    std::vector<std::array<float, 64>> seen{std::size_t(cols)};
    std::vector<int> count(std::size_t(cols), 0);
    for (int s = begin; s < end; ++s) lay(s, seen, count);
  });
  flat.joined = joined_px * extent.pitch;
  join_narrow_sectors(flat);
  return flat;
}

}  // namespace hada
