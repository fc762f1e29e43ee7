#include "measure/hills.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

// 3 x 4 hills of height 2, each with a furrow of depth 0.8 that makes two summits of it, which rise
// 0.45 above the furrow.
Grid<float> landscape() {
  Grid<float> height(90, 120);
  for (int row = 0; row < 90; ++row) {
    for (int col = 0; col < 120; ++col) {
      const double y = std::sin(std::numbers::pi * (row + 0.5) / 30.0);
      const double x = std::sin(std::numbers::pi * (col + 0.5) / 30.0);
      const double dimple = std::exp(-std::pow((col % 30 - 14.5) / 2.0, 2));
      height(row, col) = float(2.0 * x * x * y * y - 0.8 * dimple * y * y);
    }
  }
  return height;
}

// By the definition: a summit counts unless a path leads up from it that goes down by less.
int counted_one_by_one(const Grid<float>& height, const Mask& mask, double least_rise) {
  const auto is_higher = [&](std::size_t a, std::size_t b) {  // of equal ones the first
    return height[a] > height[b] || (height[a] == height[b] && a < b);
  };
  int count = 0;
  for (std::size_t start = 0; start < mask.size(); ++start) {
    if (!mask[start]) continue;
    Mask reached(mask.rows(), mask.cols(), 0);
    std::vector<std::size_t> open{start};
    bool is_hill = true;
    while (!open.empty() && is_hill) {
      const std::size_t pixel = open.back();
      open.pop_back();
      if (is_higher(pixel, start)) is_hill = false;
      const int row = int(pixel) / mask.cols(), col = int(pixel) % mask.cols();
      for (int d = 0; d < 9; ++d) {
        const int r = row + d / 3 - 1, c = col + d % 3 - 1;
        if (!mask.contains(r, c) || !mask(r, c) || reached(r, c)) continue;
        const std::size_t next = std::size_t(r * mask.cols() + c);
        if (!is_higher(next, start) && !(height[start] - height[next] < least_rise)) continue;
        reached(r, c) = 1;
        open.push_back(next);
      }
    }
    count += is_hill;
  }
  return count;
}

TEST(Hills, CountsWhatRisesFarEnough) {
  const Mask mask(90, 120, 1);
  EXPECT_EQ(hill_count(landscape(), mask, 0.5), 12);
  EXPECT_EQ(hill_count(landscape(), mask, 0.2), 24);
  EXPECT_EQ(hill_count(landscape(), mask, 5.0), 1);
}

TEST(Hills, CountsEveryRegionOfTheMaskAlone) {
  Mask mask(90, 120, 1);
  for (int row = 0; row < 90; ++row) mask(row, 60) = 0;
  EXPECT_EQ(hill_count(landscape(), mask, 5.0), 2);
}

TEST(Hills, AreThoseOfTheDefinition) {
  for (const int steps : {4, 1000}) {  // with and without plateaus
    Grid<float> height(31, 23);
    Mask mask(31, 23, 1);
    for (int row = 0; row < height.rows(); ++row) {
      for (int col = 0; col < height.cols(); ++col) {
        height(row, col) = float(std::round(steps * gaussian(7, row, col)) / steps);
        mask(row, col) = gaussian(8, row, col) < 1.5;
      }
    }
    for (const double rise : {0.2, 1.0, 2.5}) {
      const int count = hill_count(height, mask, rise);
      EXPECT_EQ(count, counted_one_by_one(height, mask, rise)) << steps << ", " << rise;
      EXPECT_GT(count, 1);
    }
  }
}

TEST(Hills, OfAPlateauIsOne) {
  EXPECT_EQ(hill_count(Grid<float>(8, 8, 1.0f), Mask(8, 8, 1), 0.1), 1);
}

}  // namespace
}  // namespace hada
