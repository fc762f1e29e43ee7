#include "capture/circle.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

// A disc of brightness 1 on 0.2, drawn with the covered share of each pixel, and noise.
Grid<float> disc(const Eigen::Vector2d& center, double radius, double noise) {
  Grid<float> picture(240, 320);
  for (int row = 0; row < picture.rows(); ++row) {
    for (int col = 0; col < picture.cols(); ++col) {
      int inside = 0;
      for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
          const Eigen::Vector2d at(col + (i + 0.5) / 8.0, row + (j + 0.5) / 8.0);
          inside += (at - center).norm() < radius;
        }
      }
      picture(row, col) = float(0.2 + 0.8 * inside / 64.0 + noise * gaussian(3, row, col));
    }
  }
  return picture;
}

TEST(Circle, CandidatesHoldTheDiscThatWasDrawn) {
  const Eigen::Vector2d center(131.3, 98.7);
  const auto candidates = circle_candidates(disc(center, 41.6, 0.02));
  ASSERT_FALSE(candidates.empty());
  // The vote counts whole pixels and steps of the radius of 2 %.
  EXPECT_LT((candidates.front().center - center).norm(), 2.5);
  EXPECT_NEAR(candidates.front().radius, 41.6, 2.0);
}

TEST(Circle, CandidatesOfAReducedPictureHoldWhatNoiseHides) {
  const Eigen::Vector2d center(161.0, 120.0);
  const Grid<float> noisy = disc(center, 90.0, 0.6);
  const auto finds = [&](const CircleSearch& search) {
    const auto candidates = circle_candidates(noisy, search);
    return std::any_of(candidates.begin(), candidates.end(), [&](const Circle& circle) {
      // Reduced, a pixel is 2.3 wide, and the radius grows in steps of 2 %.
      return (circle.center - center).norm() < 7.0 && std::abs(circle.radius - 90.0) < 7.0;
    });
  };
  EXPECT_FALSE(finds({}));
  EXPECT_TRUE(finds({.smallest_radius = 16.0, .longest_side = 140.0}));
}

TEST(Circle, RefinementFindsTheOutlineToATenthOfAPixel) {
  const Eigen::Vector2d center(131.3, 98.7);
  const Circle sharp = refined(disc(center, 41.6, 0.02), {{132.5, 97.5}, 43.0, 0.0, 0.0}, 0.12);
  // 260 radii, each placing the edge to about 0.3 px under this noise: 0.3 sqrt(2 / 260) = 0.03 px.
  EXPECT_LT((sharp.center - center).norm(), 0.1);
  EXPECT_NEAR(sharp.radius, 41.6, 0.1);
  EXPECT_GT(sharp.coverage, 0.95);
}

TEST(Circle, NoiseAloneHasNoOutline) {
  Grid<float> noise(240, 320);
  for (int row = 0; row < noise.rows(); ++row) {
    for (int col = 0; col < noise.cols(); ++col) noise(row, col) = float(gaussian(5, row, col));
  }
  EXPECT_LT(refined(noise, {{160.0, 120.0}, 50.0, 0.0, 0.0}, 0.12).coverage, 0.5);
}

TEST(Circle, CoverageIsTheShareOfTheOutlineThatIsSeen) {
  const Eigen::Vector2d center(160.0, 120.0);
  Grid<float> picture = disc(center, 50.0, 0.01);
  for (int row = 0; row < picture.rows(); ++row) {
    for (int col = 160; col < picture.cols(); ++col) picture(row, col) = 0.2f;
  }
  const Circle half = refined(picture, {center, 50.0, 0.0, 0.0}, 0.1);
  EXPECT_NEAR(half.coverage, 0.5, 0.02);
}

TEST(DiscOf, IsTheCircleOfARoundMaskOnly) {
  Mask round(80, 100, 0), square = round;
  for (int row = 0; row < 80; ++row) {
    for (int col = 0; col < 100; ++col) {
      const Eigen::Vector2d way = Eigen::Vector2d(col + 0.5, row + 0.5) - Eigen::Vector2d(52, 41);
      round(row, col) = way.norm() < 30.0;
      square(row, col) = way.cwiseAbs().maxCoeff() < 26.0;
    }
  }
  const auto disc = disc_of(round);
  ASSERT_TRUE(disc);
  // Some 190 border pixels are counted whole or not at all: 0.3 sqrt(190) px of area.
  EXPECT_LT((disc->center - Eigen::Vector2d(52, 41)).norm(), 0.05);
  EXPECT_NEAR(disc->radius, 30.0, 0.05);
  EXPECT_FALSE(disc_of(square));  // its corners, 6 % of it
  EXPECT_FALSE(disc_of(Mask(80, 100, 0)));
  EXPECT_FALSE(disc_of(Mask()));
}

}  // namespace
}  // namespace hada
