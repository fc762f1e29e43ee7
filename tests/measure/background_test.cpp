#include "measure/background.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(WithoutBackground, LeavesTheDisc) {
  Grid<float> picture(60, 60, 1.0f);
  for (int row = 0; row < 60; ++row) {
    for (int col = 0; col < 60; ++col) {
      const double r = std::hypot(row - 30.0, col - 30.0);
      if (r < 20.0) picture(row, col) = 0.4f;
      if (r < 3.0) picture(row, col) = 1.0f;  // bright, but not of the ground
    }
  }
  const Mask mask = without_background(picture, Mask(60, 60, 1), 2);
  EXPECT_EQ(mask(2, 2), 0);
  EXPECT_EQ(mask(30, 11), 0);  // the margin
  EXPECT_EQ(mask(30, 14), 1);
  EXPECT_EQ(mask(30, 30), 1);
}

TEST(WithoutBackground, TakesNothingFromWhatFillsThePicture) {
  Grid<float> picture(60, 60);
  for (int row = 0; row < 60; ++row) {
    for (int col = 0; col < 60; ++col) picture(row, col) = 0.3f + 0.01f * float(col);
  }
  EXPECT_EQ(without_background(picture, Mask(60, 60, 1), 2), Mask(60, 60, 1));
}

}  // namespace
}  // namespace hada
