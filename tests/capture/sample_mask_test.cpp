#include "capture/sample_mask.h"

#include <numeric>

#include <gtest/gtest.h>

namespace hada {
namespace {

// A bright sheet with a dark print on it, and a bright ball, on a dark table.
Grid<float> scene() {
  Grid<float> picture(120, 160, 0.02f);
  for (int row = 10; row < 110; ++row) {
    for (int col = 60; col < 150; ++col) picture(row, col) = 0.7f;
  }
  for (int row = 40; row < 60; ++row) {
    for (int col = 80; col < 110; ++col) picture(row, col) = 0.02f;
  }
  for (int row = 40; row < 80; ++row) {
    for (int col = 5; col < 45; ++col) {
      if (std::hypot(row - 59.5, col - 24.5) < 20.0) picture(row, col) = 0.6f;
    }
  }
  return picture;
}

int area(const Mask& mask) {
  return std::accumulate(mask.begin(), mask.end(), 0);
}

TEST(SampleMask, IsTheSheetWithItsPrintAndWithoutItsBorder) {
  const Sphere ball{SphereKind::matte, {25.0, 60.0}, 20.0, 0.1, {}};
  const Mask mask = sample_mask(scene(), {ball}, {});
  ASSERT_FALSE(mask.empty());
  EXPECT_EQ(area(mask), 98 * 88 - 4);  // the median takes the corners off
  EXPECT_EQ(mask(50, 90), 1);          // on the print
  EXPECT_EQ(mask(60, 25), 0);          // on the ball
  EXPECT_EQ(mask(10, 60), 0);          // on the border
}

TEST(SampleMask, LooksOnlyAroundTheBoxThatIsGiven) {
  const Mask mask = sample_mask(scene(), {}, BoxPx{2, 35, 48, 85});
  ASSERT_FALSE(mask.empty());
  EXPECT_EQ(mask(60, 25), 1);
  EXPECT_EQ(mask(60, 100), 0);
}

TEST(SampleMask, IsEverythingWhereThereIsNoTable) {
  const Mask mask = sample_mask(Grid<float>(50, 60, 0.4f), {}, {});
  EXPECT_EQ(area(mask), 50 * 60);
}

TEST(SampleMask, IsEmptyWhereOnlySpecksAreBright) {
  Grid<float> dark(120, 160, 0.01f);
  for (int i = 0; i < 6; ++i) dark(60 + i / 3, 80 + i % 3) = 0.9f;
  EXPECT_TRUE(sample_mask(dark, {}, {}).empty());
}

}  // namespace
}  // namespace hada
