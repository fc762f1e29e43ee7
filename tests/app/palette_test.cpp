#include "app/draw/palette.h"

#include <cmath>

#include <gtest/gtest.h>

#include "io/image_file.h"

namespace hada {
namespace {

// CIE lightness of a colour on the screen.
double lightness(const Colour& c) {
  const double y = 0.2126 * linear_from_srgb(c[0]) + 0.7152 * linear_from_srgb(c[1]) +
                   0.0722 * linear_from_srgb(c[2]);
  return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

TEST(Palette, LightnessGrowsEvenly) {
  // Evenness was built in another colour space than the one that judges here: the two measures of
  // lightness differ by a few percent, so steps may differ by half of their mean.
  const double mean = (lightness(sequential(1.0)) - lightness(sequential(0.0))) / 10.0;
  for (int i = 0; i < 10; ++i) {
    const double step = lightness(sequential(0.1 * (i + 1))) - lightness(sequential(0.1 * i));
    EXPECT_NEAR(step, mean, 0.5 * mean) << i;
  }
}

TEST(Palette, DivergingSidesAreEquallyLight) {
  for (const double share : {0.3, 0.6, 1.0}) {
    EXPECT_NEAR(lightness(diverging(share)), lightness(diverging(-share)), 4.0) << share;
  }
}

TEST(Palette, SharesOutsideTheRangeAreItsEnds) {
  EXPECT_EQ(sequential(-3.0), sequential(0.0));
  EXPECT_EQ(sequential(7.0), sequential(1.0));
}

TEST(Palette, CssIsHexadecimal) {
  EXPECT_EQ(css({1.0f, 0.0f, 0.5f}), "#ff0080");
}

}  // namespace
}  // namespace hada
