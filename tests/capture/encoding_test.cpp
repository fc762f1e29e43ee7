#include "capture/encoding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/srgb.h"
#include "table_scene.h"

namespace hada {
namespace {

Photographs encoded(Photographs photographs) {
  for (Image& image : photographs.images) {
    for (float& value : image.planes[0]) value = srgb_from_linear(value);
  }
  return photographs;
}

TEST(Encoding, IsSettledByWhatTheLightsExplain) {
  for (const bool linear : {true, false}) {
    Photographs photographs = table_scene({});
    photographs.encoding_known = false;
    if (!linear) photographs = encoded(std::move(photographs));
    settle_encoding(photographs, six_lights());
    EXPECT_TRUE(photographs.encoding_known);
    EXPECT_EQ(photographs.linear, linear);
    EXPECT_EQ(photographs.remarks.size(), 1u);
  }
}

TEST(Encoding, ThatIsStatedWronglyIsDoubted) {
  Photographs right = table_scene({});
  Photographs wrong = encoded(right);
  EXPECT_FALSE(doubt_of_linear(right, six_lights()));
  const auto doubt = doubt_of_linear(wrong, six_lights());
  ASSERT_TRUE(doubt);
  EXPECT_THAT(*doubt, testing::HasSubstr("srgb"));
  wrong.linear = false;
  EXPECT_FALSE(doubt_of_linear(wrong, six_lights()));
}

}  // namespace
}  // namespace hada
