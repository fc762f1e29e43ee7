#include "capture/faint_outline.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace hada {
namespace {

// What a mirror sphere looks like on a dark table: a bold dark disc inside, a bright crescent that
// mirrors the sheet, and an outline that is a step of a tenth.
Grid<float> mirror(const Eigen::Vector2d& center, double radius) {
  Grid<float> picture(240, 320);
  for (int row = 0; row < picture.rows(); ++row) {
    for (int col = 0; col < picture.cols(); ++col) {
      double sum = 0.0;
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
          const Eigen::Vector2d way =
              Eigen::Vector2d(col + (i + 0.5) / 4.0, row + (j + 0.5) / 4.0) - center;
          const double r = way.norm() / radius;
          const double angle = std::atan2(way.y(), way.x());
          if (r > 1.0) {
            sum += -4.1;
          } else if (r < 0.75) {
            sum += -7.0;
          } else {
            sum += std::abs(angle) < 0.8 && r > 0.8 && r < 0.92 ? -1.5 : -4.2;
          }
        }
      }
      picture(row, col) = float(sum / 16.0 + 0.02 * gaussian(11, row, col));
    }
  }
  return picture;
}

TEST(FaintOutline, LooksBeyondTheBoldInnerDisc) {
  const Eigen::Vector2d center(151.4, 117.8);
  const Grid<float> picture = mirror(center, 60.0);
  const auto outline = faint_outline(picture, {{150.5, 118.5}, 45.0, 1.0, 0.1}, {});
  ASSERT_TRUE(outline.has_value());
  // A step five times its noise is placed to about 0.3 px on each of 240 radii.
  EXPECT_NEAR(outline->radius, 60.0, 0.4);
  EXPECT_LT((outline->center - center).norm(), 0.3);
}

// A black mirror before a wall that ends half-way down, over black cloth: only the upper half of
// its outline shows, in places twice as bold as in others.
TEST(FaintOutline, PlacesAMirrorByHalfItsOutline) {
  const Eigen::Vector2d center(151.4, 117.8);
  Grid<float> picture(240, 320);
  for (int row = 0; row < picture.rows(); ++row) {
    for (int col = 0; col < picture.cols(); ++col) {
      double sum = 0.0;
      for (int i = 0; i < 16; ++i) {
        const Eigen::Vector2d at(col + (i % 4 + 0.5) / 4.0, row + (i / 4 + 0.5) / 4.0);
        const Eigen::Vector2d way = at - center;
        const double r = way.norm() / 90.0;
        const double wall = at.y() < 130.0 ? 0.25 + 0.1 * at.x() / 320.0 : 0.0;
        const bool window = way.x() < 0.0 && way.y() < 20.0 && r > 0.8 && r < 0.95;
        sum += r > 1.0 ? wall : window ? 0.6 : way.y() < -60.0 ? 0.12 : 0.0;
      }
      picture(row, col) = float(sum / 16.0);
      if (row < 130) picture(row, col) += float(0.01 * gaussian(13, row, col));
    }
  }
  const auto outline = faint_outline(picture, {{151.9, 117.2}, 89.0, 1.0, 0.1}, {});
  ASSERT_TRUE(outline.has_value());
  // Half an outline tells radius and height of the middle apart ten times less well than a whole.
  EXPECT_NEAR(outline->radius, 90.0, 0.3);
  EXPECT_LT((outline->center - center).norm(), 0.3);
}

TEST(FaintOutline, BelievesARadiusThatIsKnown) {
  const Eigen::Vector2d center(151.4, 117.8);
  const auto outline = faint_outline(mirror(center, 60.0), {{150.5, 118.5}, 45.0, 1.0, 0.1}, 60.0);
  ASSERT_TRUE(outline.has_value());
  EXPECT_EQ(outline->radius, 60.0);
  EXPECT_LT((outline->center - center).norm(), 0.3);
}

TEST(FaintOutline, SaysNothingOfAPlainTable) {
  Grid<float> picture(240, 320);
  for (int row = 0; row < picture.rows(); ++row) {
    for (int col = 0; col < picture.cols(); ++col) {
      picture(row, col) = float(0.02 * gaussian(12, row, col));
    }
  }
  EXPECT_FALSE(faint_outline(picture, {{160.0, 120.0}, 45.0, 1.0, 0.1}, {}).has_value());
}

}  // namespace
}  // namespace hada
