#include "measure/plane_share.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

TEST(PlaneShare, IsTheVarianceOfThePlaneOverAll) {
  Grid<float> height(40, 60);
  Mask mask(40, 60, 1);
  double plane = 0.0;
  for (int row = 0; row < 40; ++row) {
    for (int col = 0; col < 60; ++col) {
      const double tilt = 0.3 * (col - 29.5) - 0.1 * (row - 19.5);
      plane += tilt * tilt / 2400.0;
      height(row, col) = float(7.0 + tilt + 2.0 * gaussian(1, row, col));
    }
  }
  // Noise of variance 4, known to sqrt(2 / 2400) of it, with which the plane correlates by chance.
  EXPECT_NEAR(plane_share(height, mask), plane / (plane + 4.0), 0.02);
  mask(0, 0) = 0;
  height(0, 0) = 1e6f;  // not read
  EXPECT_NEAR(plane_share(height, mask), plane / (plane + 4.0), 0.02);
}

TEST(PlaneShare, IsNothingOfAFlatMapAndAllOfAPlane) {
  Grid<float> height(16, 16, 0.1f);  // whose sums are rounded
  const Mask mask(16, 16, 1);
  EXPECT_EQ(plane_share(height, mask), 0.0);
  for (int row = 0; row < 16; ++row) {
    for (int col = 0; col < 16; ++col) height(row, col) = float(row - 2 * col);
  }
  EXPECT_NEAR(plane_share(height, mask), 1.0, 1e-9);
}

}  // namespace
}  // namespace hada
