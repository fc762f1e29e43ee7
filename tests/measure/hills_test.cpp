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

int count(const Grid<float>& height, const Mask& mask, double least_rise) {
  return hills(height, mask, {.least_rise = [=](std::size_t) { return least_rise; }}).count;
}

TEST(Hills, CountsWhatRisesFarEnough) {
  const Mask mask(90, 120, 1);
  EXPECT_EQ(count(landscape(), mask, 0.5), 12);
  EXPECT_EQ(count(landscape(), mask, 0.2), 24);
  EXPECT_EQ(count(landscape(), mask, 5.0), 1);
}

TEST(Hills, CountsEveryRegionOfTheMaskAlone) {
  Mask mask(90, 120, 1);
  for (int row = 0; row < 90; ++row) mask(row, 60) = 0;
  EXPECT_EQ(count(landscape(), mask, 5.0), 2);
}

TEST(Hills, DivideTheGroundAmongThem) {
  const auto found =
      hills(landscape(), Mask(90, 120, 1), {.least_rise = [](std::size_t) { return 0.5; }});
  // Every hill has its own rectangle of 30 x 30, up to the valleys between.
  for (int row = 0; row < 90; ++row) {
    for (int col = 0; col < 120; ++col) {
      if (row % 30 == 0 || row % 30 == 29 || col % 30 == 0 || col % 30 == 29) continue;
      EXPECT_EQ(found.of_pixel(row, col), found.of_pixel(row / 30 * 30 + 15, col / 30 * 30 + 10));
    }
  }
}

TEST(Hills, JoinAcrossTheBorderWhereColumnsWrap) {
  Grid<float> height(1, 8);
  for (int col = 0; col < 8; ++col) height(0, col) = float(std::abs(col - 3));
  const auto rise = [](std::size_t) { return 1.0; };
  EXPECT_EQ(hills(height, Mask(1, 8, 1), {.least_rise = rise}).count, 2);
  EXPECT_EQ(hills(height, Mask(1, 8, 1), {.least_rise = rise, .columns_wrap = true}).count, 1);
}

TEST(Hills, OfAPlateauIsOne) {
  EXPECT_EQ(count(Grid<float>(8, 8, 1.0f), Mask(8, 8, 1), 0.1), 1);
}

}  // namespace
}  // namespace hada
