#include "synth/knit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "core/error.h"
#include "synth/knit_loops.h"

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

float colour_of(const Knit<>& knit, int course, int channel) {
  const int index = int(knit.colour_repeat[std::size_t(course)] + 0.5);
  const auto& yarn = knit.yarns[std::size_t(std::clamp(index, 0, int(knit.yarns.size()) - 1))];
  return float(channel == 0 ? yarn.red : channel == 1 ? yarn.green : yarn.blue);
}

}  // namespace

Surface surface_of(const Knit<>& knit, const Extent& extent, Seed) {
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
  std::vector<YarnPoint> points;
  for (int j = -int(most); j <= most; ++j) {
    for (int i = -int(most); i <= most; ++i) {
      const Eigen::Vector2d middle =
          pixels_per_stitch * Eigen::Vector2d(i - knit.wale_phase, j - knit.course_phase);
      const Eigen::Vector2d share(middle.x() / extent.cols, middle.y() / extent.rows);
      if (share.x() < -0.5 || share.x() >= 0.5 || share.y() < -0.5 || share.y() >= 0.5) continue;
      for (const auto& [wales, courses, z] : curve) {
        const Eigen::Vector2d at = middle + pixels_per_stitch * Eigen::Vector2d(wales, courses);
        points.push_back({0.5 * extent.rows - 0.5 - at.y(), at.x() + 0.5 * extent.cols - 0.5, z,
                          wrapped_index(j, repeat)});
      }
    }
  }
  const auto maps = seen_from_above(points, knit.yarn_radius_mm, extent.rows, extent.cols,
                                    {extent.pitch, extent.pitch}, true);
  Surface surface;
  surface.extent = extent;
  surface.mask = full_mask(extent);
  surface.height = maps.height;
  surface.normals = maps.normals;
  surface.albedo = Image(extent.rows, extent.cols, 3);
  double sum = 0.0;
  for (const float z : maps.height) sum += z;
  const float mean = float(sum / double(maps.height.size()));
  for (std::size_t k = 0; k < surface.height.size(); ++k) {
    surface.height[k] -= mean;
    for (int c = 0; c < 3 && maps.course[k] >= 0; ++c) {
      surface.albedo.planes[std::size_t(c)][k] = colour_of(knit, maps.course[k], c);
    }
  }
  return surface;
}

}  // namespace hada
