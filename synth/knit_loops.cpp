#include "synth/knit_loops.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "core/parallel.h"

namespace hada {
namespace {

constexpr float unseen = -std::numeric_limits<float>::infinity();

int wrapped_index(int k, int n) {
  return ((k % n) + n) % n;
}

/// Draws the spheres around `points` into the rows [begin, end); a normal is as long as the radius
/// until all are drawn, since most are drawn over.
void stamp(KnitMaps& maps, const std::vector<YarnPoint>& points, double radius, int begin, int end,
           std::array<double, 2> mm_per_px, bool wraps) {
  const int cols = maps.height.cols(), rows = maps.height.rows();
  const double reach_row = radius / mm_per_px[1];
  for (const YarnPoint& point : points) {
    for (int r = int(std::ceil(point.row - reach_row)); r <= point.row + reach_row; ++r) {
      const int row = wraps ? wrapped_index(r, rows) : r;
      if (row < begin || row >= end) continue;
      const double dy = (point.row - r) * mm_per_px[1];
      const double half = std::sqrt(std::max(0.0, radius * radius - dy * dy)) / mm_per_px[0];
      for (int c = int(std::ceil(point.col - half)); c <= point.col + half; ++c) {
        const int col = wraps ? wrapped_index(c, cols) : c;
        if (col < 0 || col >= cols) continue;
        if (point.height_mm + radius <= maps.height(row, col)) continue;
        const double dx = (c - point.col) * mm_per_px[0];
        const double dz = std::sqrt(std::max(0.0, radius * radius - dx * dx - dy * dy));
        const float z = float(point.height_mm + dz);
        if (z <= maps.height(row, col)) continue;
        maps.height(row, col) = z;
        maps.course(row, col) = std::int16_t(point.course);
        maps.normals(row, col) = Eigen::Vector3d(dx, dy, dz + 1e-6 * radius).cast<float>();
      }
    }
  }
}

}  // namespace

KnitMaps seen_from_above(const std::vector<YarnPoint>& points, double radius_mm, int rows, int cols,
                         std::array<double, 2> mm_per_px, bool wraps) {
  KnitMaps maps{Grid<float>(rows, cols, unseen), NormalMap(rows, cols, Eigen::Vector3f::UnitZ()),
                Grid<std::int16_t>(rows, cols, -1)};
  for_slices(rows, [&](int begin, int end) {
    stamp(maps, points, radius_mm, begin, end, mm_per_px, wraps);
    for (int row = begin; row < end; ++row) {
      for (auto& normal : maps.normals.row(row)) normal.normalize();
    }
  });
  float lowest = std::numeric_limits<float>::max();
  for (const float z : maps.height) lowest = z == unseen ? lowest : std::min(lowest, z);
  if (lowest == std::numeric_limits<float>::max()) lowest = 0.0f;  // no yarn anywhere
  for (float& z : maps.height) z = z == unseen ? lowest : z;
  return maps;
}

std::vector<std::array<double, 3>> loop_curve(const Knit<>& knit) {
  constexpr double pi = std::numbers::pi;
  constexpr double step_in_radii = 0.25;  // leaves ripples of radius / 128 on the yarn
  const double length = knit.wale_mm * (1.0 + 8.0 * knit.loop_width) +
                        4.0 * knit.loop_reach * knit.course_mm + 8.0 * knit.loop_depth_mm;
  const int count = std::clamp(int(length / (step_in_radii * knit.yarn_radius_mm)), 24, 4096);
  std::vector<std::array<double, 3>> curve;
  for (int k = 0; k < count; ++k) {
    const double t = pi * (2.0 * k / count - 1.0);
    curve.push_back({t / (2.0 * pi) + knit.loop_width * std::sin(2.0 * t),
                     knit.loop_reach * std::cos(t), -knit.loop_depth_mm * std::cos(2.0 * t)});
  }
  return curve;
}

KnitMaps knit_maps(const Knit<>& knit, const Extent& extent, Seed seed,
                   const KnitPictureOptions& options) {
  const double c = std::cos(knit.rotation_rad), s = std::sin(knit.rotation_rad);
  const double lean = knit.rotation_rad + knit.skew_rad;
  const Eigen::Vector2d along(c, s), up(-std::sin(lean), std::cos(lean));
  Eigen::Array2d low = Eigen::Array2d::Constant(1e300), high = -low;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      const auto [i, j] = stitch_at(knit, x * extent.width(), y * extent.height());
      low = low.min(Eigen::Array2d(i, j));
      high = high.max(Eigen::Array2d(i, j));
    }
  }
  const auto curve = loop_curve(knit);
  const int repeat = int(knit.colour_repeat.size());
  std::vector<YarnPoint> points;
  for (int j = int(low.y()) - 3; j <= high.y() + 3; ++j) {
    for (int i = int(low.x()) - 3; i <= high.x() + 3; ++i) {
      const double shift_x = options.jitter_mm * gaussian(seed, i, j, 0);
      const double shift_y = options.jitter_mm * gaussian(seed, i, j, 1);
      for (const auto& [wales, courses, z] : curve) {
        const double x =
            place_of(i + wales - knit.wale_phase, knit.wale_mm, knit.wale_gradient_per_mm);
        // The reach of a loop is the same everywhere: the middle of the course moves, not its size.
        const double y =
            place_of(j - knit.course_phase, knit.course_mm, knit.course_gradient_per_mm) +
            courses * knit.course_mm;
        const Eigen::Vector2d pixel = extent.pixel((x + shift_x) * along + (y + shift_y) * up);
        points.push_back({pixel[0], pixel[1], z, wrapped_index(j, repeat)});
      }
    }
  }
  return seen_from_above(points, knit.yarn_radius_mm, extent.rows, extent.cols,
                         {extent.pitch, extent.pitch}, false);
}

}  // namespace hada
