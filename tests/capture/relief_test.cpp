#include "capture/relief.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

// A ridge along the columns: height 2 at column 50, falling by `slope` per cell to either side.
Grid<float> ridge(float slope) {
  Grid<float> height(101, 101);
  for (int row = 0; row < 101; ++row) {
    for (int col = 0; col < 101; ++col) {
      height(row, col) = std::max(0.0f, 2.0f - slope * float(std::abs(col - 50)));
    }
  }
  return height;
}

Eigen::Vector3d from_the_right(double elevation) {
  return {std::cos(elevation), 0.0, std::sin(elevation)};
}

TEST(Relief, HidesWhatLiesBehindARidgeFromALowLight) {
  const Relief relief(ridge(1.0f), 0.5);
  // At an elevation of tan = 0.4 the shadow of the top, 2 high, ends 5 to the left: 10 cells,
  // or up to one less, as the ray is looked at once in a cell.
  const Eigen::Vector3d light = from_the_right(std::atan(0.4));
  EXPECT_TRUE(relief.hides({30.0, 41.0}, 0.0, light));
  EXPECT_FALSE(relief.hides({30.0, 39.8}, 0.0, light));
  EXPECT_FALSE(relief.hides({30.0, 60.0}, 0.0, light));
  EXPECT_FALSE(relief.hides({30.0, 50.0}, 2.0, light));
}

TEST(Relief, NeverHidesItselfFromALightSteeperThanItsSlopes) {
  const Grid<float> height = ridge(0.1f);
  const Relief relief(height, 0.5);
  const Eigen::Vector3d light = from_the_right(std::atan(0.3));  // the ridge: 0.1 / 0.5 = 0.2
  for (int col = 1; col < 100; ++col) EXPECT_FALSE(relief.hides({9.0, col}, height(9, col), light));
}

TEST(Relief, LetsLightInFromOutsideAndFromAbove) {
  const Relief relief(ridge(1.0f), 0.5);
  EXPECT_FALSE(relief.hides({-20.0, 500.0}, 0.0, from_the_right(0.1)));
  EXPECT_FALSE(relief.hides({30.0, 49.0}, 1.0, Eigen::Vector3d::UnitZ()));
}

}  // namespace
}  // namespace hada
