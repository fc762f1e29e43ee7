#include "measure/streaks.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

/// White noise along x, sheared by `slope`.
Grid<float> sheared(int rows, int cols, double slope, Seed seed) {
  Grid<float> map(rows, cols);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const double x = col + slope * row + 4000.0;  // up and to the right
      const double left = std::floor(x), t = x - left;
      map(row, col) =
          float((1.0 - t) * gaussian(seed, std::int64_t(left)) +
                t * gaussian(seed, std::int64_t(left) + 1) + 0.3 * gaussian(seed + 1, row, col));
    }
  }
  return map;
}

TEST(Streaks, LeanAsTheyWereSheared) {
  for (const double slope : {-0.3, 0.0, 0.1}) {
    const Extent extent{200, 320, 0.1, Unit::mm};
    const auto seen = streaks(sheared(200, 320, slope, 1), Mask(200, 320, 1), extent);
    ASSERT_GT(seen.size(), 10u);
    double mean = 0.0;
    for (const Streak& one : seen) mean += one.slope / double(seen.size());
    // A tenth of a pixel over 24 rows, with noise of a third.
    EXPECT_NEAR(mean, slope, 0.004);
  }
}

TEST(Streaks, AreNoneInNoise) {
  Grid<float> map(200, 320);
  for (std::size_t i = 0; i < map.size(); ++i) map[i] = float(gaussian(2, std::int64_t(i)));
  EXPECT_LT(streaks(map, Mask(200, 320, 1), {200, 320, 0.1, Unit::mm}).size(), 3u);
}

TEST(Streaks, AreNoneOnAPlainMap) {
  EXPECT_TRUE(
      streaks(Grid<float>(100, 100, 0.5f), Mask(100, 100, 1), {100, 100, 1.0, Unit::px}).empty());
}

}  // namespace
}  // namespace hada
