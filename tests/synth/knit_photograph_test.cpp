#include "synth/knit_photograph.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace hada {
namespace {

BentKnit even(int courses, int wales) {
  BentKnit bent{courses, wales, {}};
  for (int j = 0; j < courses; ++j) {
    for (int i = 0; i < wales; ++i) {
      bent.places.emplace_back(2.0 * (i - 0.5 * (wales - 1)), 1.5 * (j - 0.5 * (courses - 1)), 0.0);
    }
  }
  return bent;
}

Knit<> blue_and_yellow() {
  Knit<> knit;
  knit.wale_mm = 2.0, knit.course_mm = 1.5, knit.yarn_radius_mm = 0.3, knit.loop_depth_mm = 0.24;
  knit.colour_repeat = {0.0, 1.0};
  knit.yarns = {{0.1, 0.2, 0.6}, {0.7, 0.6, 0.1}};
  return knit;
}

TEST(KnitPhotograph, ShowsYarnsOnADarkTable) {
  const Extent extent{140, 160, 0.1, Unit::mm};
  const Image picture = knit_photograph(blue_and_yellow(), even(5, 4), extent, 1, {.noise = 0.0});
  EXPECT_LT(picture.planes[0](3, 3), 0.03f);  // the table
  int blue = 0, yellow = 0;
  for (int row = 40; row < 100; ++row) {
    for (int col = 50; col < 110; ++col) {
      const float red = picture.planes[0](row, col), other = picture.planes[2](row, col);
      blue += other > 1.5f * red && other > 0.1f;
      yellow += red > 1.5f * other && red > 0.1f;
    }
  }
  EXPECT_GT(blue, 600);
  EXPECT_GT(yellow, 600);
}

TEST(KnitPhotograph, HoldsEightBitsAndTheNoiseAskedFor) {
  const Extent extent{60, 60, 0.1, Unit::mm};
  const auto with = [&](double noise) {
    return knit_photograph(blue_and_yellow(), even(5, 4), extent, 7, {.noise = noise});
  };
  const Image clean = with(0.0), noisy = with(0.02);
  std::vector<float> values(clean.planes[1].begin(), clean.planes[1].end());
  std::sort(values.begin(), values.end());
  EXPECT_LE(std::unique(values.begin(), values.end()) - values.begin(), 256);
  double sum = 0.0, count = 0.0;
  for (std::size_t k = 0; k < noisy.planes[1].size(); ++k) {
    if (clean.planes[1][k] < 0.1f) continue;  // darker ones are clipped
    const double off = noisy.planes[1][k] - clean.planes[1][k];
    sum += off * off, count += 1.0;
  }
  EXPECT_NEAR(std::sqrt(sum / count), 0.02, 0.002);  // 2000 values: 1.6 %
  EXPECT_EQ(with(0.02), noisy);
}

}  // namespace
}  // namespace hada
