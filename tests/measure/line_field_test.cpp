#include "measure/line_field.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace hada {
namespace {

Grid<float> stripes(int size, double angle) {
  Grid<float> map(size, size);
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col) {
      const double along = col * std::cos(angle) - row * std::sin(angle);  // y is up
      map(row, col) = float(std::sin(0.5 * along));
    }
  }
  return map;
}

TEST(LineField, IsAcrossTheLines) {
  for (const double angle : {0.0, 0.4, 1.2, 2.5}) {
    const auto field = line_field(stripes(80, angle), Mask(80, 80, 1));
    // A central difference of a wave of 0.5 rad/px falls short by 0.5^2 / 6 = 4 %, more along the
    // steeper axis: 0.02 rad between the axes at most.
    EXPECT_NEAR(std::sin(double(field.across(40, 40)) - angle), 0.0, 0.02) << angle;
    EXPECT_GT(field.coherence(40, 40), 0.99f);
  }
}

TEST(LineField, KnowsNothingBesideTheMask) {
  Mask mask(80, 80, 1);
  for (int row = 0; row < 80; ++row) {
    for (int col = 0; col < 20; ++col) mask(row, col) = 0;
  }
  auto map = stripes(80, 0.4);
  const auto field = line_field(map, mask);
  for (int row = 0; row < 80; ++row) map(row, 10) = 1000.0f;  // outside: must not be read
  const auto same = line_field(map, mask);
  EXPECT_EQ(field.xx, same.xx);
  EXPECT_EQ(field.xy, same.xy);
  EXPECT_EQ(field.strength(40, 5), 0.0f);
  EXPECT_GT(field.strength(40, 60), 0.0f);
}

TEST(LineField, SeesNoDirectionOnAPlainMap) {
  const auto field = line_field(Grid<float>(40, 40, 0.5f), Mask(40, 40, 1));
  for (int k = 0; k < 40; ++k) EXPECT_EQ(field.strength(k, (7 * k) % 40), 0.0f);
}

}  // namespace
}  // namespace hada
