#include "synth/knit_tile.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "core/error.h"

namespace hada {
namespace {

int wrapped_index(int k, int n) {
  return ((k % n) + n) % n;
}

/// Cycles of wales and of courses over the width and the height of `extent`, whole numbers.
Eigen::Matrix2d whole_cycles(const Knit<>& knit, const Extent& extent) {
  const auto [wx, cx] = fabric_place(knit, extent.width(), 0.0);
  const auto [wy, cy] = fabric_place(knit, 0.0, extent.height());
  const double repeat = double(knit.colour_repeat.size());
  Eigen::Matrix2d cycles;
  cycles << std::round(wx / knit.wale_mm), std::round(wy / knit.wale_mm),
      repeat * std::round(cx / knit.course_mm / repeat),
      repeat * std::round(cy / knit.course_mm / repeat);
  // Less than half a stitch fits: one does.
  cycles(0, 0) = std::max(cycles(0, 0), 1.0);
  cycles(1, 1) = std::max(cycles(1, 1), repeat);
  // Rounded so, courses may run along wales: on so few stitches they run along x.
  if (std::abs(cycles.determinant()) < 0.5) cycles(0, 1) = cycles(1, 0) = 0.0;
  return cycles;
}

}  // namespace

KnitMaps tile_maps(const Knit<>& knit, const Extent& extent) {
  if (knit.yarn_radius_mm > std::max(knit.wale_mm, knit.course_mm)) {
    throw Error("knit: a yarn_radius_mm above wale_mm and course_mm leaves no loops to be seen");
  }
  const Eigen::Matrix2d cycles = whole_cycles(knit, extent);
  const Eigen::Matrix2d pixels_per_stitch =
      Eigen::Vector2d(extent.cols, extent.rows).asDiagonal() * cycles.inverse();
  const auto curve = loop_curve(knit);
  const int repeat = int(knit.colour_repeat.size());
  // The stitches whose middle lies on the surface: a unit square of cycles, torn by the rounding.
  const double most = cycles.cwiseAbs().rowwise().sum().maxCoeff() + 1.0;
  constexpr double tie = 1e-9;  // one that lies on a seam is drawn once, whatever its rounding
  std::vector<YarnPoint> points;
  for (int j = -int(most); j <= most; ++j) {
    for (int i = -int(most); i <= most; ++i) {
      const Eigen::Vector2d middle =
          pixels_per_stitch * Eigen::Vector2d(i - knit.wale_phase, j - knit.course_phase);
      const Eigen::Vector2d share(middle.x() / extent.cols, middle.y() / extent.rows);
      if ((share.array() < -0.5 - tie).any() || (share.array() >= 0.5 - tie).any()) continue;
      for (const auto& [wales, courses, z] : curve) {
        const Eigen::Vector2d at = middle + pixels_per_stitch * Eigen::Vector2d(wales, courses);
        points.push_back({0.5 * extent.rows - 0.5 - at.y(), at.x() + 0.5 * extent.cols - 0.5, z,
                          wrapped_index(j, repeat)});
      }
    }
  }
  return seen_from_above(points, knit.yarn_radius_mm, extent.rows, extent.cols,
                         {extent.pitch, extent.pitch}, true);
}

Grid<float> tile_opacity(const Knit<>& knit, const Extent& extent) {
  // Three places to a pixel each way, so that edges are soft, while there is room for them.
  constexpr double most_places = 1.5e8;
  const int finer = 9.0 * extent.rows * extent.cols < most_places ? 3 : 1;
  const Extent fine{finer * extent.rows, finer * extent.cols, extent.pitch / finer, extent.unit};
  const KnitMaps maps = tile_maps(knit, fine);
  Grid<float> opacity(extent.rows, extent.cols, 0.0f);
  const float part = 1.0f / float(finer * finer);
  for (int row = 0; row < fine.rows; ++row) {
    for (int col = 0; col < fine.cols; ++col) {
      if (maps.course(row, col) >= 0) opacity(row / finer, col / finer) += part;
    }
  }
  for (float& share : opacity) share = std::min(share, 1.0f);
  return opacity;
}

}  // namespace hada
