#include "core/extent.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(Extent, PutsTheOriginInTheMiddleAndRowZeroAtTheTop) {
  const Extent odd{3, 5, 0.5, Unit::mm};
  EXPECT_EQ(odd.place(1, 2), Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(odd.place(0, 0), Eigen::Vector2d(-1.0, 0.5));
  const Extent even{2, 4, 1.0, Unit::px};
  EXPECT_EQ(even.place(0.5, 1.5), Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(odd.width(), 2.5);
  EXPECT_EQ(odd.height(), 1.5);
}

TEST(Extent, FindsThePixelOfItsPlace) {
  const Extent extent{300, 201, 0.26, Unit::mm};
  for (const double row : {-3.0, 0.0, 0.25, 299.0}) {
    for (const double col : {0.0, 17.5, 200.0}) {
      const Eigen::Vector2d pixel = extent.pixel(extent.place(row, col));
      EXPECT_NEAR(pixel.x(), row, 1e-12);  // some roundings of numbers below 512
      EXPECT_NEAR(pixel.y(), col, 1e-12);
    }
  }
}

TEST(Extent, NamesItsUnit) {
  EXPECT_EQ(name_of(Unit::mm), "mm");
  EXPECT_EQ(name_of(Unit::px), "px");
}

}  // namespace
}  // namespace hada
