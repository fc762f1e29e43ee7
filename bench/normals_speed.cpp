#include "bench/normals_speed.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/parallel.h"
#include "core/random.h"
#include "reconstruct/band.h"

namespace hada {
namespace {

constexpr int lights = 12;
constexpr int runs = 5;
constexpr double noise = 0.003;
constexpr int drawn_rows = 256;  // the rows below repeat them
constexpr double never = std::numeric_limits<double>::max();

LightStack pictures(int side) {
  LightStack stack;
  stack.camera.extent = {.rows = side, .cols = side};
  stack.mask = full_mask(stack.camera.extent);
  for (int k = 0; k < lights; ++k) {
    const double azimuth = 2.0 * std::numbers::pi * k / lights;
    const double tilt = k % 2 == 0 ? 0.8 : 0.5;
    Light light;
    light.direction = {std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth),
                       std::cos(tilt)};
    stack.lights.push_back(light);
    stack.images.emplace_back(side, side, 1);
    stack.samples.emplace_back(side, side, Sample::lit);
  }
  for_each_index(std::min(side, drawn_rows), [&](int row) {
    for (int col = 0; col < side; ++col) {
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
  for (Image& image : stack.images) {
    Grid<float>& plane = image.planes[0];
    for (int row = drawn_rows; row < side; ++row) {
      std::copy_n(plane.row(row - drawn_rows).begin(), side, plane.row(row).begin());
    }
  }
  return stack;
}

// Eight sums, so that the additions do not wait for each other.
float sum_of_samples(const LightStack& stack) {
  float sums[8] = {};
  for (const Image& image : stack.images) {
    const float* values = image.planes[0].data();
    const std::size_t count = image.planes[0].size() / 8 * 8;
    for (std::size_t i = 0; i < count; i += 8) {
      for (std::size_t j = 0; j < 8; ++j) sums[j] += values[i + j];
    }
  }
  return std::accumulate(std::begin(sums), std::end(sums), 0.0f);
}

// Of the processor, which waits for other programs do not lengthen; nothing here has two threads.
template <class Work>
double seconds_of(const Work& work) {
  const std::clock_t begin = std::clock();
  work();
  return double(std::clock() - begin) / CLOCKS_PER_SEC;
}

}  // namespace

std::vector<NormalSpeed> normal_speed(const std::vector<Estimator>& estimators,
                                      const NormalSpeedOptions& options) {
  const LightStack stack = pictures(options.side);
  NormalMaps maps(stack, true);
  std::vector<NormalSpeed> speeds;
  for (const Estimator estimator : estimators) {
    const TileSource source{.stack = stack, .all_count = estimator == Estimator::least_squares};
    const NormalPlan plan = plan_normals(source, estimator);
    NormalSpeed best{estimator, never, options.uncertainty ? never : 0.0, never};
    const double per_pixel = 1e9 / (double(options.side) * options.side);
    const auto better = [&](double& figure, const auto& work) {
      figure = std::min(figure, per_pixel * seconds_of(work));
    };
    for (int run = 0; run < runs; ++run) {
      better(best.plain_read, [&] {
        volatile float kept = sum_of_samples(stack);
        static_cast<void>(kept);
      });
      better(best.nanoseconds, [&] { solve_band(source, plan, 0, options.side, false, maps); });
      if (!options.uncertainty) continue;
      better(best.with_uncertainty, [&] { solve_band(source, plan, 0, options.side, true, maps); });
    }
    speeds.push_back(best);
  }
  return speeds;
}

}  // namespace hada
