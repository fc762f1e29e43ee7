#include "core/image.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(Luminance, WeighsColoursAndCopiesGrey) {
  Image image(1, 3, 3);
  for (int c = 0; c < 3; ++c) image.planes[std::size_t(c)](0, c) = 1.0f;
  const Grid<float> grey = luminance(image);
  for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(grey(0, c), luminance_weight[c]);
  EXPECT_EQ(luminance(Image(grey)), grey);
}

TEST(Luminance, LeavesWhiteWhite) {
  Image white(2, 2, 3);
  for (auto& plane : white.planes) plane = Grid<float>(2, 2, 1.0f);
  EXPECT_NEAR(luminance(white)(1, 1), 1.0, 2e-7);  // three weights, each rounded to 2^-24
}

TEST(Luminance, TakesOtherWeights) {
  Image image(1, 1, 3);
  for (int c = 0; c < 3; ++c) image.planes[std::size_t(c)](0, 0) = float(1 << c);
  EXPECT_EQ(luminance(image, {0.5f, 0.25f, 2.0f})(0, 0), 0.5f + 0.5f + 8.0f);
}

TEST(ImageCrop, CutsEveryPlane) {
  Image image(3, 3, 3);
  image.planes[2](1, 2) = 5.0f;
  const Image part = crop(image, 1, 1, 2, 2);
  EXPECT_EQ(part.channels(), 3);
  EXPECT_EQ(part.rows(), 2);
  EXPECT_EQ(part.planes[2](0, 1), 5.0f);
}

}  // namespace
}  // namespace hada
