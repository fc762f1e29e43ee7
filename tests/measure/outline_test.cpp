#include "measure/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"

namespace hada {
namespace {

using Eigen::Vector2d;

// The pixels whose centre lies in a rectangle of these half sides, turned.
Mask rectangle(const Extent& extent, double half_x, double half_y, double deg) {
  Mask mask(extent.rows, extent.cols, 0);
  const double c = std::cos(deg * std::numbers::pi / 180.0),
               s = std::sin(deg * std::numbers::pi / 180.0);
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      const Vector2d p = extent.place(row, col);
      mask(row, col) =
          std::abs(c * p.x() + s * p.y()) < half_x && std::abs(-s * p.x() + c * p.y()) < half_y;
    }
  }
  return mask;
}

TEST(Outline, OfATurnedSheetHasItsCorners) {
  const Extent extent{300, 360, 0.2, Unit::mm};
  for (const double deg : {0.0, 7.0, 33.0}) {
    Mask mask = rectangle(extent, 22.0, 14.0, deg);
    mask(3, 3) = mask(4, 3) = 1;  // a speck beside it
    const auto corners = outline_of(mask, extent);
    ASSERT_EQ(corners.size(), 4u) << deg;
    double area = 0.0;
    const double c = std::cos(deg * std::numbers::pi / 180.0),
                 s = std::sin(deg * std::numbers::pi / 180.0);
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector2d &p = corners[k], &q = corners[(k + 1) % 4];
      area += 0.5 * (p.x() * q.y() - p.y() * q.x());
      // Sides through contour pixels: to a pixel.
      EXPECT_NEAR(std::abs(c * p.x() + s * p.y()), 22.0, extent.pitch);
      EXPECT_NEAR(std::abs(-s * p.x() + c * p.y()), 14.0, extent.pitch);
    }
    EXPECT_NEAR(area, 44.0 * 28.0, 2.0 * (44.0 + 28.0) * extent.pitch);  // > 0: counter-clockwise
  }
}

TEST(Outline, OfNothingIsRefused) {
  const Extent extent{20, 20, 1.0, Unit::px};
  EXPECT_THROW(outline_of(Mask(20, 20, 0), extent), Error);
}

}  // namespace
}  // namespace hada
