#include "capture/thrown_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.h"

namespace hada {
namespace {

struct Patch {
  Eigen::Vector3d place;
  double area;
  std::vector<double> values;  // of each picture; 0 where a sphere covers it
};

bool on_a_sphere(const std::vector<Sphere>& spheres, int row, int col) {
  return std::any_of(spheres.begin(), spheres.end(), [&](const Sphere& sphere) {
    const Eigen::Vector2d at(col + 0.5, row + 0.5);
    return (at - sphere.center_px).norm() < sphere.radius_px + 2.0;
  });
}

// The picture in blocks, fine enough that a sphere's own width holds several.
std::vector<Patch> patches(const std::vector<Grid<float>>& greys, const Camera& camera,
                           const std::vector<Sphere>& spheres) {
  const Extent& extent = camera.extent;
  constexpr int across = 40;
  double smallest = 1e9;
  for (const Sphere& sphere : spheres) smallest = std::min(smallest, sphere.radius_px);
  const int block =
      std::max(1, std::min(std::max(extent.rows, extent.cols) / across, int(0.5 * smallest)));
  const int rows = (extent.rows + block - 1) / block;
  const int cols = (extent.cols + block - 1) / block;
  std::vector<Patch> all(std::size_t(rows) * std::size_t(cols));
  for_each_index(rows, [&](int block_row) {
    for (int block_col = 0; block_col < cols; ++block_col) {
      const int first_row = block_row * block;
      const int first_col = block_col * block;
      const int last_row = std::min(first_row + block, extent.rows);
      const int last_col = std::min(first_col + block, extent.cols);
      Patch patch{Eigen::Vector3d::Zero(), 0.0, std::vector<double>(greys.size(), 0.0)};
      const Eigen::Vector2d place =
          extent.place(0.5 * (first_row + last_row - 1), 0.5 * (first_col + last_col - 1));
      patch.place = {place.x(), place.y(), 0.0};
      for (int row = first_row; row < last_row; ++row) {
        for (int col = first_col; col < last_col; ++col) {
          if (on_a_sphere(spheres, row, col)) continue;
          patch.area += extent.pitch * extent.pitch;
          for (std::size_t k = 0; k < greys.size(); ++k) patch.values[k] += greys[k](row, col);
        }
      }
      const double pixels = std::max(1.0, patch.area / (extent.pitch * extent.pitch));
      for (double& value : patch.values) value /= pixels;
      all[std::size_t(block_row) * std::size_t(cols) + std::size_t(block_col)] = std::move(patch);
    }
    const int begin = block_row * block;
    for (const auto& grey : greys) grey.let_go(begin, std::min(begin + block, extent.rows));
  });
  return all;
}

}  // namespace

std::vector<std::vector<double>> thrown_light(const std::vector<Grid<float>>& greys,
                                              const Camera& camera,
                                              const std::vector<Sphere>& spheres,
                                              const std::vector<Hit<double>>& points) {
  const auto from = patches(greys, camera, spheres);
  std::vector<std::vector<double>> thrown(greys.size(), std::vector<double>(points.size(), 0.0));
  for_each_index(int(points.size()), [&](int point) {
    const auto p = std::size_t(point);
    for (const Patch& patch : from) {
      const Eigen::Vector3d way = patch.place - points[p].point;
      const double facing = points[p].normal.dot(way);
      if (facing <= 0.0 || way.z() >= 0.0) continue;
      const double square = way.squaredNorm();
      const double share = facing * -way.z() * patch.area / (std::numbers::pi * square * square);
      for (std::size_t k = 0; k < greys.size(); ++k) thrown[k][p] += share * patch.values[k];
    }
  });
  return thrown;
}

}  // namespace hada
