#include "fit/dark_wood.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

constexpr int side = 400;
const Extent extent{side, side, 1.0, Unit::mm};
const GrowthFrame frame{{-260.0, 30.0}, {}};

/// Rings 45 px wide, each half as bright at its end as where it begins, with noise of 3 % and
/// vessels of half the brightness every 40 px.
Grid<float> picture(double radius) {
  Grid<float> map(side, side);
  for (int row = 0; row < side; ++row) {
    for (int col = 0; col < side; ++col) {
      const double through = std::fmod(frame.rho_of(extent.place(row, col)), 45.0) / 45.0;
      double value =
          0.8 * (1.0 - 0.5 * std::pow(through, 3)) * (1.0 + 0.03 * gaussian(5, row, col));
      const double off = std::hypot(std::remainder(row - 20, 40), std::remainder(col - 20, 40));
      if (off < radius) value *= 0.5;
      map(row, col) = float(value);
    }
  }
  return map;
}

TEST(DarkWood, IsVesselsAndNoLatewood) {
  const auto seen = dark_wood(picture(6.0), full_mask(extent), frame, extent);
  ASSERT_TRUE(seen);
  ASSERT_EQ(seen->discs.size(), 100u);
  // Noise of 3 % of what is half as bright: some hundred pixels each, ten times their error.
  EXPECT_NEAR(seen->depth, 0.5, 0.01);
  for (const Disc& disc : seen->discs) {
    EXPECT_LT(std::abs(std::remainder(disc.place.x() - 20.0, 40.0)), 1.0);
    EXPECT_LT(std::abs(std::remainder(disc.place.y() - 20.0, 40.0)), 1.0);
    EXPECT_NEAR(disc.radius, 6.0, 0.5);  // drawn on whole pixels
  }
}

TEST(DarkWood, IsNoneWithoutVessels) {
  EXPECT_FALSE(dark_wood(picture(0.0), full_mask(extent), frame, extent));
}

TEST(DarkWood, IsNotToldWhereVesselsAreTooSmall) {
  EXPECT_FALSE(dark_wood(picture(3.0), full_mask(extent), frame, extent));
}

TEST(DarkWood, IsFoundWhereVesselsAreRare) {
  // Twelve vessels, less than a per cent of the picture.
  Grid<float> map = picture(0.0);
  const Grid<float> all = picture(6.0);
  for (int row = 0; row < side; ++row) {
    for (int col = 0; col < side; ++col)
      if (row / 40 == 4 || (row / 40 == 7 && col < 80)) map(row, col) = all(row, col);
  }
  const auto seen = dark_wood(map, full_mask(extent), frame, extent);
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->discs.size(), 12u);
}

}  // namespace
}  // namespace hada
