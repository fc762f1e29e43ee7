#include "fit/grain_view.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "fit/sequence_posterior.h"
#include "synth/forged.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

struct Lying {
  double angle_rad = 0.0;
  double scale = 1.0;
  double aspect = 1.0;
};

/// A block photographed askew: four samples between the places for a pixel, then noise and a tone.
Grid<float> photographed(const std::string& sequence, const Lying& lying, int rows, int cols,
                         Seed seed) {
  const auto block = forged_block({.sequence = sequence}, {1024, 2048}, seed);
  const double c = std::cos(lying.angle_rad), s = std::sin(lying.angle_rad);
  Grid<float> grey(rows, cols);
  double squares = 0.0;
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      double sum = 0.0;
      for (const double down : {0.25, 0.75}) {
        for (const double right : {0.25, 0.75}) {
          const double x = col + right - 0.5 * cols, y = 0.5 * rows - row - down;
          const double at_col = 1000.0 + (c * x + s * y) / (lying.scale * lying.aspect);
          const double at_row = 500.0 - (c * y - s * x) / lying.scale;
          const int i = int(at_row), j = int(at_col);
          const double a = at_row - i, b = at_col - j;
          sum += (1 - a) * ((1 - b) * block(i, j) + b * block(i, j + 1)) +
                 a * ((1 - b) * block(i + 1, j) + b * block(i + 1, j + 1));
        }
      }
      grey(row, col) = float(0.25 * sum);
      squares += grey(row, col) * double(grey(row, col)) / (double(rows) * cols);
    }
  }
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const double z = grey(row, col) / std::sqrt(squares) + 0.1 * gaussian(seed + 1, row, col);
      grey(row, col) = float(std::round(255.0 / (1.0 + std::exp(-0.8 * z))));
    }
  }
  return grey;
}

TEST(GrainView, LooksThroughATurnedAndScaledPicture) {
  const Lying lying{3.0 * degree, 1.08, 0.97};
  const auto grey = photographed("CCRCC", lying, 256, 384, 3);
  const auto seen = seen_grain(grey, {.fewest_folds = 5, .most_folds = 5, .refined = 4}, true);
  const auto posterior = sequence_posterior(seen.candidates, seen.spectrum, 1.0);
  EXPECT_EQ(posterior.likeliest.model.sequence, "CCRCC");
  // Grain 8 places longer than wide, some 700 independent places: 1/8 over the root, in rad, is a
  // quarter of a degree; four of that.
  EXPECT_NEAR(seen.rotation_rad / degree, 3.0, 1.0);
  // A size is known to 1 / 2 over the root of the places, some 2 %; more than twice that.
  EXPECT_NEAR(posterior.likeliest.fit.nuisance.scale, lying.scale, 0.05);
  EXPECT_NEAR(posterior.likeliest.fit.nuisance.aspect, lying.aspect, 0.05);
}

TEST(GrainView, LeavesALevelPictureAsItIs) {
  const auto grey = photographed("CRCR", {}, 128, 192, 4);
  const auto seen = seen_grain(grey, {.fewest_folds = 4, .most_folds = 4, .refined = 4}, true);
  EXPECT_EQ(seen.rotation_rad, 0.0);
  EXPECT_EQ(sequence_posterior(seen.candidates, seen.spectrum, 1.0).likeliest.model.sequence,
            "CRCR");
}

}  // namespace
}  // namespace hada
