#include "capture/overview.h"

#include <cmath>

#include <gtest/gtest.h>

#include "io/image_file.h"

namespace hada {
namespace {

Photographs two_pictures(float first, float second) {
  Photographs photographs;
  photographs.bits = 16;
  for (const float value : {first, second}) {
    photographs.images.emplace_back(Grid<float>(20, 30, value));
  }
  return photographs;
}

TEST(Overview, HoldsTheMeanOfTheLogarithmsAndTheBrightest) {
  const Overview all = overview(two_pictures(0.2f, 0.6f));
  const double least = 0.002 * 0.2;
  EXPECT_NEAR(all.mean_log(3, 4), 0.5 * (std::log(0.2 + least) + std::log(0.6 + least)), 1e-6);
  EXPECT_EQ(all.brightest(3, 4), 0.6f);
  EXPECT_EQ(all.bright, (std::vector<float>{0.2f, 0.6f}));
}

TEST(Overview, UndoesTheCurveOfPicturesThatCarryIt) {
  Photographs photographs = two_pictures(srgb_from_linear(0.3f), srgb_from_linear(0.5f));
  photographs.linear = false;
  EXPECT_NEAR(overview(photographs).brightest(0, 0), 0.5f, 1e-6f);
}

}  // namespace
}  // namespace hada
