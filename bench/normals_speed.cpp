#include "bench/normals_speed.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/parallel.h"
#include "core/random.h"
#include "reconstruct/band.h"

namespace hada {
namespace {

constexpr int lights = 12;
constexpr int runs = 3;
constexpr double noise = 0.003;

LightStack pictures(int rows, int cols) {
  LightStack stack;
  stack.camera.extent = {.rows = rows, .cols = cols};
  stack.mask = full_mask(stack.camera.extent);
  for (int k = 0; k < lights; ++k) {
    const double azimuth = 2.0 * std::numbers::pi * k / lights;
    const double tilt = k % 2 == 0 ? 0.8 : 0.5;
    Light light;
    light.direction = {std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth),
                       std::cos(tilt)};
    stack.lights.push_back(light);
    stack.images.emplace_back(rows, cols, 1);
    stack.samples.emplace_back(rows, cols, Sample::lit);
  }
  for_each_index(rows, [&](int row) {
    for (int col = 0; col < cols; ++col) {
      const Eigen::Vector3d normal =
          Eigen::Vector3d(0.3 * std::sin(0.05 * col), 0.3 * std::cos(0.07 * row), 1.0).normalized();
      const double luck = uniform(7, row, col);
      for (int k = 0; k < lights; ++k) {
        double value = 0.6 * normal.dot(stack.lights[std::size_t(k)].direction);
        // Rounded to 12 bits, with noise of the same kind from a cheap hash.
        value += noise * (uniform(8, row, col, k) + uniform(9, row, col, k) - 1.0) * 2.449;
        if (luck < 0.1 && int(luck * 10.0 * lights) == k) value = luck < 0.05 ? 0.1 * value : 1.0;
        stack.images[std::size_t(k)].planes[0](row, col) = float(value);
      }
    }
  });
  return stack;
}

}  // namespace

std::vector<NormalSpeed> normal_speed(int rows, int cols,
                                      const std::vector<Estimator>& estimators) {
  const LightStack stack = pictures(rows, cols);
  NormalMaps maps(stack, true);
  std::vector<NormalSpeed> speeds;
  for (const Estimator estimator : estimators) {
    const TileSource source{.stack = stack, .all_count = estimator == Estimator::least_squares};
    const NormalPlan plan = plan_normals(source, estimator);
    const auto best = [&](bool uncertainty) {
      double seconds = std::numeric_limits<double>::max();
      for (int run = 0; run < runs; ++run) {
        const auto begin = std::chrono::steady_clock::now();
        solve_band(source, plan, 0, rows, uncertainty, maps);
        const auto end = std::chrono::steady_clock::now();
        seconds = std::min(seconds, std::chrono::duration<double>(end - begin).count());
      }
      return 1e9 * seconds / (double(rows) * cols);
    };
    speeds.push_back({estimator, best(false), best(true)});
  }
  return speeds;
}

}  // namespace hada
