#include "fit/grain_turn.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"
#include "synth/forged.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

TEST(GrainTurn, LevelsAWave) {
  // A wave along the direction 5 degrees above the rows, at a third of the Nyquist frequency.
  const double angle = 5.0 * degree, turn = 2.0 * std::numbers::pi / 6.0;
  Grid<float> wave(160, 240);
  for (int row = 0; row < 160; ++row) {
    for (int col = 0; col < 240; ++col) {
      const double x = col - 119.5, y = 79.5 - row;
      wave(row, col) = float(std::cos(turn * (x * std::cos(angle) + y * std::sin(angle))));
    }
  }
  const auto level = turned_back(wave, angle);
  ASSERT_GT(level.rows(), 110);
  ASSERT_GT(level.cols(), 200);
  EXPECT_LT(level.rows(), 160);
  for (int row = 0; row < level.rows(); ++row) {
    for (int col = 0; col < level.cols(); ++col) {
      // The cropped middle may lie half a pixel off: (rows - cropped) / 2 is rounded down.
      const double x = col + (240 - level.cols()) / 2 - 119.5;
      // A windowed sinc of twelve pixels errs by some 1e-3 of such a wave, three times.
      ASSERT_NEAR(level(row, col), std::cos(turn * x), 5e-3) << row << " " << col;
    }
  }
}

TEST(GrainTurn, KeepsWhiteNoiseWhite) {
  Grid<float> noise(256, 256);
  for (int row = 0; row < 256; ++row) {
    for (int col = 0; col < 256; ++col) noise(row, col) = float(gaussian(3, row, col));
  }
  const auto level = turned_back(noise, -4.0 * degree);
  double squares = 0.0, products = 0.0;
  for (int row = 0; row < level.rows(); ++row) {
    for (int col = 1; col < level.cols(); ++col) {
      squares += double(level(row, col)) * level(row, col);
      products += double(level(row, col)) * level(row, col - 1);
    }
  }
  const double n = double(level.rows()) * level.cols();
  // Within 1/12 of the Nyquist frequency the window takes up to all power, in two shears along the
  // rows: 2 * 0.4 / 12 of the whole, where neighbours are opposite. Four sigma of a mean: 0.02.
  EXPECT_NEAR(squares / n, 1.0, 0.1);
  EXPECT_NEAR(products / n, 0.0, 0.1);
}

TEST(GrainTurn, FindsTheAxesOfTurnedGrain) {
  auto block = crop(forged_block({.sequence = "CCRCCR"}, {1024, 2048}, 4), 200, 500, 384, 640);
  double mean = 0.0;
  for (const float g : block) mean += g / double(block.size());
  for (float& g : block) g -= float(mean);
  // Grain that hangs together over 2^4 places shows its axis to some 1/16 over the root of the
  // 384 x 640 / 2^6 independent places: 0.06 degrees; four of that.
  EXPECT_NEAR(mirror_axis(block) / degree, 0.0, 0.25);
  const auto turned = turned_back(block, -6.0 * degree);
  EXPECT_NEAR(mirror_axis(turned) / degree, 6.0, 0.25);
}

}  // namespace
}  // namespace hada
