#include "fit/dark_discs.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

/// Discs drawn eight times finer than they are looked at, with noise.
Grid<float> picture(const std::vector<Disc>& discs) {
  constexpr int finer = 8;
  Grid<float> dark(60, 80);
  for (int row = 0; row < dark.rows(); ++row) {
    for (int col = 0; col < dark.cols(); ++col) {
      double sum = 0.05 * finer * finer * gaussian(4, row, col);
      for (int k = 0; k < finer * finer; ++k) {
        const Eigen::Vector2d place(row + (k / finer + 0.5) / finer - 0.5,
                                    col + (k % finer + 0.5) / finer - 0.5);
        sum += std::any_of(discs.begin(), discs.end(), [&](const Disc& disc) {
          return (place - disc.place).norm() < disc.radius;
        });
      }
      dark(row, col) = float(sum / (finer * finer));
    }
  }
  return dark;
}

/// Each of `discs` has been found: place and radius to a share of a px.
void expect_found(const std::vector<Disc>& discs, double within) {
  const auto found = dark_discs(picture(discs));
  ASSERT_EQ(found.size(), discs.size());
  for (const Disc& disc : discs) {
    const auto nearest =
        std::min_element(found.begin(), found.end(), [&](const Disc& a, const Disc& b) {
          return (a.place - disc.place).norm() < (b.place - disc.place).norm();
        });
    EXPECT_LT((nearest->place - disc.place).norm(), within);
    EXPECT_NEAR(nearest->radius, disc.radius, within);
  }
}

TEST(DarkDiscs, AreFoundBetweenPixels) {
  // Some 40 crossings of noise 0.05 px each: 0.01 px; a border that curves within a pixel adds
  // 1 / (24 r).
  expect_found({{{20.3, 18.7}, 5.4}, {{40.1, 60.4}, 7.7}}, 0.1);
}

TEST(DarkDiscs, AreTakenApartWhereTheyOverlap) {
  expect_found({{{22.0, 20.5}, 6.0}, {{26.5, 29.0}, 5.0}, {{24.0, 60.0}, 5.5}}, 0.5);
}

TEST(DarkDiscs, KnowWhetherTheyLieAlone) {
  int alone = 0;
  for (const Disc& disc :
       dark_discs(picture({{{22.0, 20.5}, 6.0}, {{26.5, 29.0}, 5.0}, {{24.0, 60.0}, 5.5}})))
    alone += disc.alone ? 1 : 0;
  EXPECT_EQ(alone, 1);
}

}  // namespace
}  // namespace hada
