#include "reconstruct/multigrid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "reconstruct/regions.h"
#include "scenes.h"

namespace hada {
namespace {

// Random, and of zero sum in every region: what the Laplacian can be inverted on.
std::vector<float> random_values(const PixelGraph& graph, const Mask& mask, Seed seed) {
  const Regions regions = regions_of(mask);
  std::vector<double> sum(regions.size.size(), 0.0);
  for (int row = 0; row < graph.rows; ++row) {
    for (int col = 0; col < graph.cols; ++col) {
      sum[std::size_t(regions.label(row, col))] += gaussian(seed, row, col);
    }
  }
  std::vector<float> values(graph.size(), 0.0f);
  for (int row = 0; row < graph.rows; ++row) {
    for (int col = 0; col < graph.cols; ++col) {
      if (!mask(row, col)) continue;
      const auto region = std::size_t(regions.label(row, col));
      values[graph.first(row) + std::size_t(col)] =
          float(gaussian(seed, row, col) - sum[region] / regions.size[region]);
    }
  }
  return values;
}

std::vector<float> cycled(Multigrid& multigrid, const std::vector<float>& right) {
  multigrid.right() = right;
  multigrid.cycle();
  return multigrid.value();
}

double dot(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += double(a[i]) * b[i];
  return sum;
}

TEST(PixelGraph, HasAnEdgeBetweenNeighboursOfTheMaskOnly) {
  Mask mask(2, 3, 1);
  mask(1, 1) = 0;
  const PixelGraph graph(mask);
  EXPECT_EQ(std::count(graph.east.begin(), graph.east.end(), 1.0f), 2);
  EXPECT_EQ(std::count(graph.south.begin(), graph.south.end(), 1.0f), 2);
  EXPECT_EQ(graph.inverse[graph.first(0) + 1], 0.5f);
}

TEST(Multigrid, IsSymmetricAndPositiveAsConjugateGradientsAsk) {
  const Mask mask = torn_mask(70, 61, 2);
  Multigrid multigrid(mask);
  const auto a = random_values(multigrid.finest(), mask, 11);
  const auto b = random_values(multigrid.finest(), mask, 12);
  const auto inverse_a = cycled(multigrid, a);
  const auto inverse_b = cycled(multigrid, b);
  EXPECT_GT(dot(a, inverse_a), 0.0);
  // Both sides are sums of about 4000 float products; 1e-4 of their natural size is rounding.
  const double size = std::sqrt(dot(a, inverse_a) * dot(b, inverse_b));
  EXPECT_NEAR(dot(a, inverse_b), dot(b, inverse_a), 1e-4 * size);
}

}  // namespace
}  // namespace hada
