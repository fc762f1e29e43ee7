#include "reconstruct/weighted_solver.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "reconstruct/regions.h"
#include "scenes.h"

namespace hada {
namespace {

TEST(WeightedSolver, SharesADisagreementOutAsTheWeightsSay) {
  // Round a square of four pixels the rises add up to 1: each step takes a part in proportion to 1
  // over its weight.
  EdgeWeights weights{Grid<float>(2, 2, 1.0f), Grid<float>(2, 2, 1.0f)};
  weights.east(0, 0) = 0.25f;
  EdgeRises rises{Grid<float>(2, 2, 0.0f), Grid<float>(2, 2, 0.0f)};
  rises.east(0, 0) = 1.0f;
  const Mask mask(2, 2, 1);
  WeightedSolver solver(mask, weights);
  const auto height = solver.solve(rises, 1e-9, 20).height;
  EXPECT_NEAR(height(0, 1) - height(0, 0), 1.0 - 4.0 / 7.0, 1e-7);
  EXPECT_NEAR(height(1, 1) - height(0, 1), -1.0 / 7.0, 1e-7);
  EXPECT_NEAR(height(1, 0) - height(1, 1), -1.0 / 7.0, 1e-7);
}

TEST(WeightedSolver, NeedsFewCyclesForManyPlatesOnWeakEdges) {
  constexpr int size = 300;
  const Mask mask = torn_mask(size, size, 3);
  Grid<float> weight(size, size);
  Grid<double> truth(size, size);
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col) {
      weight(row, col) = uniform(9, row / 17, col / 13) < 0.5 ? 1e-6f : 1.0f;
      truth(row, col) = 20.0 * std::sin(0.02 * row) * std::cos(0.03 * col);
    }
  }
  EdgeRises rises{Grid<float>(size, size), Grid<float>(size, size)};
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col) {
      if (col + 1 < size) rises.east(row, col) = float(truth(row, col + 1) - truth(row, col));
      if (row + 1 < size) rises.south(row, col) = float(truth(row + 1, col) - truth(row, col));
    }
  }
  const auto solve = [&](int threads) {
    set_threads(threads);
    return WeightedSolver(mask, edge_weights(weight)).solve(rises, 5e-5, 100);
  };
  const auto one = solve(1);
  const auto two = solve(2);
  set_threads(0);
  EXPECT_EQ(one.height, two.height);
  EXPECT_LE(one.cycles, 4);  // 1.5 times the three that a mask without weights takes
  const Regions regions = regions_of(mask);
  std::vector<double> mean(regions.size.size(), 0.0);
  const auto for_pixels = [&](const auto& work) {
    for (int row = 0; row < size; ++row) {
      for (int col = 0; col < size; ++col) {
        if (!mask(row, col)) continue;
        work(std::size_t(regions.label(row, col)), one.height(row, col) - truth(row, col));
      }
    }
  };
  for_pixels([&](std::size_t region, double e) { mean[region] += e / regions.size[region]; });
  double sum = 0.0;
  for_pixels([&](std::size_t region, double e) { sum += std::pow(e - mean[region], 2); });
  EXPECT_LT(std::sqrt(sum / (size * size - regions.size[0])), 1e-4);
}

TEST(WeightedSolver, TakesAWeightOfZeroForACut) {
  const Mask mask(1, 3, 1);
  EdgeWeights weights{Grid<float>(1, 3, 1.0f), Grid<float>(1, 3, 1.0f)};
  weights.east(0, 1) = 0.0f;
  EdgeRises rises{Grid<float>(1, 3, 1.0f), Grid<float>(1, 3, 0.0f)};
  const auto height = WeightedSolver(mask, weights).solve(rises, 1e-9, 20).height;
  EXPECT_NEAR(height(0, 1) - height(0, 0), 1.0, 1e-7);
  EXPECT_TRUE(std::isfinite(height(0, 2)));
}

}  // namespace
}  // namespace hada
