#include "measure/measured_map.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(MeasuredMap, IsTheHeightWhereThereIsOne) {
  Surface surface;
  surface.height = Grid<float>(2, 3, 0.5f);
  surface.albedo = Image(Grid<float>(2, 3, 0.8f));
  EXPECT_EQ(measured_map(surface), surface.height);
}

TEST(MeasuredMap, IsTheBrightnessOfAPictureAsItLooks) {
  Surface picture;
  picture.albedo = Image(1, 3, 3);
  for (auto& plane : picture.albedo.planes) {
    plane(0, 1) = 0.2140f;  // half way between black and white, IEC 61966-2-1
    plane(0, 2) = 1.0f;
  }
  const Grid<float> map = measured_map(picture);
  EXPECT_EQ(map(0, 0), 0.0f);
  EXPECT_NEAR(map(0, 1), 0.5f, 1e-4f);
  EXPECT_NEAR(map(0, 2), 1.0f, 1e-6f);
}

}  // namespace
}  // namespace hada
