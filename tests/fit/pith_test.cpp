#include "fit/pith.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace hada {
namespace {

constexpr Extent extent{.rows = 300, .cols = 400, .pitch = 0.1, .unit = Unit::mm};

/// Rings around `pith` with noise of 3 degrees, every tenth direction wild.
PithGuess guess_of(const Eigen::Vector2d& pith, Seed seed) {
  Grid<float> none(extent.rows, extent.cols);
  LineField field{none, none, none};
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      const Eigen::Vector2d arm = extent.place(row, col) - pith;
      double angle = std::atan2(arm.y(), arm.x()) + 0.05 * gaussian(seed, row, col);
      if (uniform(seed + 1, row, col) < 0.1) angle = 3.14 * uniform(seed + 2, row, col);
      constexpr double coherence = 0.9;
      field.xx(row, col) = float(0.5 * (1.0 + coherence * std::cos(2.0 * angle)));
      field.yy(row, col) = float(0.5 * (1.0 - coherence * std::cos(2.0 * angle)));
      field.xy(row, col) = float(0.5 * coherence * std::sin(2.0 * angle));
    }
  }
  return pith_guess(ring_directions(field, extent), extent);
}

TEST(Pith, IsWhereNormalsMeetInsideThePicture) {
  const Eigen::Vector2d pith(4.0, -3.0);
  // A thousand lines that miss by 0.05 rad at 15 mm meet to 0.75 mm / sqrt(1000 / 2) = 0.03;
  // times 5.
  EXPECT_LT((guess_of(pith, 1).place - pith).norm(), 0.17);
}

TEST(Pith, IsFoundOutsideThePicture) {
  const Eigen::Vector2d pith(35.0, 5.0);
  // Seen from 15 to 55 mm away within 40 degrees, across the view as above, along it 3 times worse.
  EXPECT_LT((guess_of(pith, 5).place - pith).norm(), 0.8);
}

TEST(Pith, NeedsDirections) {
  EXPECT_THROW(pith_guess({}, extent), Error);
}

}  // namespace
}  // namespace hada
