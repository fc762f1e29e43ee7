#include "synth/painted.h"

#include <gtest/gtest.h>

#include "core/srgb.h"
#include "synth/synthesize.h"

namespace hada {
namespace {

Surface drawn() {
  const Wrinkle<> wrinkle{.components = {{0.1, 5.0, 2.0, 0.7}}};
  return synthesize(wrinkle, {48, 64, 1.0, Unit::px}, 3);
}

TEST(Painted, IsTheSurfaceItselfWhereItsFieldIsAHeight) {
  const Surface same = painted(drawn(), {});
  EXPECT_EQ(same.height, drawn().height);
  EXPECT_EQ(same.albedo, drawn().albedo);
}

TEST(Painted, HasTheFieldForItsBrightnessAndOneHue) {
  const std::vector<double> mean{0.9, 0.6, 0.3};
  const Surface field = drawn();
  const Surface sheet = painted(field, mean);
  EXPECT_FALSE(sheet.has_height());
  EXPECT_TRUE(sheet.normals.empty());
  ASSERT_EQ(sheet.albedo.channels(), 3);
  const float middle =
      srgb_from_linear(float(0.2126 * mean[0] + 0.7152 * mean[1] + 0.0722 * mean[2]));
  const Grid<float> grey = luminance(sheet.albedo);
  for (std::size_t i = 0; i < grey.size(); ++i) {
    ASSERT_NEAR(srgb_from_linear(grey[i]), middle + field.height[i], 1e-5f);
    ASSERT_NEAR(sheet.albedo.planes[1][i], sheet.albedo.planes[0][i] * 2.0f / 3.0f, 1e-6f);
  }
}

TEST(Painted, IsBlackWhereTheFieldIsLowerStill) {
  Surface field = drawn();
  field.height(5, 6) = -0.9f;
  const Surface sheet = painted(field, {0.5});
  ASSERT_EQ(sheet.albedo.channels(), 1);
  EXPECT_EQ(sheet.albedo.planes[0](5, 6), 0.0f);
}

}  // namespace
}  // namespace hada
