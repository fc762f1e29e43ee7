#include "reconstruct/prior_heights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"

namespace hada {
namespace {

const float unknown = std::nanf("");

float cosine(int col, int cols, double wavelength) {
  return float(std::cos(2.0 * std::numbers::pi * (col - 0.5 * (cols - 1)) / wavelength));
}

TEST(PriorHeights, LetWavesThroughAsTheGaussianFilterDoes) {
  constexpr int rows = 120, cols = 320;
  constexpr double cutoff = 64.0;
  for (const double wavelength : {32.0, 64.0, 160.0}) {
    PriorHeights prior{Grid<float>(rows, cols), cutoff};
    for (int row = 0; row < rows; ++row) {
      for (int col = 0; col < cols; ++col) prior.height(row, col) = cosine(col, cols, wavelength);
    }
    Grid<float> height(rows, cols);
    level(height, Mask(rows, cols, 1), prior);
    // Half at the cutoff: 2^-(cutoff / wavelength)^2. Blocks are b = sigma / 4 = 3 px wide and
    // joined by lines, which is made good for up to (k b)^2, 0.35 at the shortest; of what is left,
    // (k b)^4 / 100, the wave has a sixteenth. The kernel ends at four sigma: 6e-5.
    const double share = std::exp2(-std::pow(cutoff / wavelength, 2));
    // Near the sides waves are cut, which shows in the mean.
    double most = -1.0, least = 1.0;
    for (int col = 80; col < 240; ++col) {
      const double off = height(60, col) - share * cosine(col, cols, wavelength);
      most = std::max(most, off);
      least = std::min(least, off);
    }
    EXPECT_LT(most - least, 2e-3) << wavelength;
  }
}

TEST(PriorHeights, LeaveTheHeightItsShortWaves) {
  constexpr int size = 200;
  Grid<float> height(size, size), before(size, size);
  PriorHeights prior{Grid<float>(size, size, unknown), 80.0};
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col) {
      before(row, col) = cosine(col, size, 10.0);
      // Integration has bent it, and one pixel in seven is known.
      height(row, col) = before(row, col) + 1e-4f * float((row - 100) * (row - 100));
      if (uniform(3, row, col) < 1.0 / 7.0) prior.height(row, col) = 0.0f;
    }
  }
  level(height, Mask(size, size, 1), prior);
  // Of the bend, up to 1, the filter leaves the second derivative times sigma^2 / 2: 1e-4 * 15^2.
  // Of the short wave it takes what the spots show: 1 / sqrt(2) / sqrt(4 pi sigma^2 / 7) = 0.05
  // rms.
  double squares = 0.0;
  for (int row = 50; row < 150; ++row) {
    for (int col = 50; col < 150; ++col) {
      squares += std::pow(double(height(row, col)) - before(row, col), 2);
    }
  }
  EXPECT_LT(std::sqrt(squares / 1e4), 0.0225 + 1.5 * 0.05);
}

TEST(PriorHeights, LevelEveryRegionAndFadeBeyondWhatIsKnown) {
  constexpr int rows = 60, cols = 300;
  Mask mask(rows, cols, 1);
  Grid<float> height(rows, cols);
  for (int row = 0; row < rows; ++row) {
    mask(row, 100) = 0;
    for (int col = 0; col < cols; ++col)
      height(row, col) = float(col < 100 ? 3.0 : -1.0 + 0.01 * col);
  }
  // A flat surface, known in three spots of either region.
  PriorHeights prior{Grid<float>(rows, cols, unknown), 20.0};
  for (const int col : {20, 60, 120, 180}) prior.height(5, col) = 2.0f;
  prior.height(40, 40) = prior.height(40, 150) = 2.0f;
  Grid<float> with_step = height;
  level(height, mask, prior);
  EXPECT_EQ(height(7, 100), 0.0f);
  // The tilt is shared: it is half a cent in the mean, and what is left fades away from the spots.
  EXPECT_NEAR(height(5, 60), height(5, 120), 0.4f);
  double sum = 0.0;
  for (const float value : height) sum += value;
  EXPECT_NEAR(sum / (rows * cols), 0.0, 1e-5);

  // Regions of one tilt are put beside each other exactly.
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col)
      with_step(row, col) = float(0.01 * col + (col < 100 ? 3.0 : -1.0));
  }
  level(with_step, mask, prior);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) EXPECT_NEAR(with_step(row, col), 0.0f, 1e-5f);
  }
}

TEST(PriorHeights, OfATrackSayNothingOfTheTiltAcrossIt) {
  constexpr int size = 300;
  Grid<float> height(size, size);
  PriorHeights prior{Grid<float>(size, size, unknown), 20.0};
  for (int col = 0; col < size; ++col) {
    // As a line is drawn with pixels: a third of one wide.
    prior.height(int(std::lround(0.3 * col)), col) = 0.1f * float(gaussian(4, col, 0));
  }
  level(height, Mask(size, size, 1), prior);
  for (const float value : height) EXPECT_LT(std::abs(value), 0.5f);
}

TEST(PriorHeights, OfACutoffBeyondAnyMapAreAnOffsetAndATilt) {
  constexpr int size = 60;
  Grid<float> height(size, size);
  PriorHeights prior{Grid<float>(size, size), 1e300};
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col)
      prior.height(row, col) = 0.1f * float(col) + cosine(row, size, 20.0);
  }
  level(height, Mask(size, size, 1), prior);
  // The cosine has 3 whole waves, and no tilt.
  EXPECT_NEAR(height(7, 50) - height(7, 10), 4.0f, 1e-3f);
  EXPECT_NEAR(height(10, 30) - height(50, 30), 0.0f, 1e-3f);
}

TEST(PriorHeights, AreTheSameAtAnyNumberOfThreads) {
  constexpr int size = 150;
  Grid<float> first(size, size), second;
  PriorHeights prior{Grid<float>(size, size, unknown), 30.0};
  for (std::size_t i = 0; i < first.size(); ++i) {
    first[i] = float(gaussian(1, std::int64_t(i), 0));
    if (i % 5 == 0) prior.height[i] = float(gaussian(2, std::int64_t(i), 0));
  }
  second = first;
  set_threads(1);
  level(first, Mask(size, size, 1), prior);
  set_threads(3);
  level(second, Mask(size, size, 1), prior);
  set_threads(0);
  EXPECT_EQ(first, second);
}

TEST(PriorHeights, MustKnowAPixelOfTheMask) {
  Grid<float> height(20, 20);
  Mask mask(20, 20, 0);
  mask(3, 3) = mask(3, 4) = 1;
  PriorHeights prior{Grid<float>(20, 20, unknown), 8.0};
  prior.height(9, 9) = 1.0f;
  EXPECT_THROW(level(height, mask, prior), Error);
}

TEST(PriorHeights, OfCellsAreKnownWhereOneOfTheirPixelsIs) {
  PriorHeights prior{Grid<float>(5, 7, unknown), 12.0};
  prior.height(4, 6) = 8.0f;
  const PriorHeights cells = prior.zeros_of_cells(4);
  EXPECT_EQ(cells.cutoff_px, 3.0);
  ASSERT_EQ(cells.height.rows(), 2);
  ASSERT_EQ(cells.height.cols(), 2);
  EXPECT_EQ(cells.height(1, 1), 0.0f);
  EXPECT_TRUE(std::isnan(cells.height(0, 1)));
}

}  // namespace
}  // namespace hada
