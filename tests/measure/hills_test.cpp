#include "measure/hills.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

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

TEST(HillCount, CountsWhatRisesFarEnough) {
  const Mask mask(90, 120, 1);
  EXPECT_EQ(hill_count(landscape(), mask, 0.5), 12);
  EXPECT_EQ(hill_count(landscape(), mask, 0.2), 24);
  EXPECT_EQ(hill_count(landscape(), mask, 5.0), 1);
}

TEST(HillCount, CountsEveryRegionOfTheMaskAlone) {
  Mask mask(90, 120, 1);
  for (int row = 0; row < 90; ++row) mask(row, 60) = 0;
  EXPECT_EQ(hill_count(landscape(), mask, 5.0), 2);
}

TEST(HillCount, OfAPlateauIsOne) {
  EXPECT_EQ(hill_count(Grid<float>(8, 8, 1.0f), Mask(8, 8, 1), 0.1), 1);
}

}  // namespace
}  // namespace hada
