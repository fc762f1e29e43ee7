#include "core/surface.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace hada {
namespace {

constexpr double pitch = 0.1;
constexpr float nowhere = std::numeric_limits<float>::quiet_NaN();

Grid<float> height_of(const Extent& extent, const auto& z) {
  Grid<float> height(extent.rows, extent.cols);
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      const Eigen::Vector2d place = extent.place(row, col);
      height(row, col) = float(z(place.x(), place.y()));
    }
  }
  return height;
}

TEST(NormalsOf, AreThoseOfAPlaneEverywhere) {
  const Extent extent{9, 12, pitch, Unit::mm};
  const auto height = height_of(extent, [](double x, double y) { return 0.5 * x - 0.25 * y; });
  const Eigen::Vector3f truth = Eigen::Vector3f(-0.5f, 0.25f, 1.0f).normalized();
  for (const auto& normal : normals_of(height, full_mask(extent), pitch)) {
    // Heights below 0.5 are rounded to 2^-25; a one-sided slope doubles it and divides by pitch.
    EXPECT_LT((normal - truth).norm(), 2 * 0x1p-25 / pitch + 2 * 0x1p-23);
  }
}

TEST(NormalsOf, AreThoseOfAParaboloidAwayFromTheBorder) {
  const Extent extent{21, 21, pitch, Unit::mm};
  // Central differences of a quadratic are exact.
  const auto height =
      height_of(extent, [](double x, double y) { return -0.2 * x * x + 0.1 * x * y; });
  const auto normals = normals_of(height, full_mask(extent), pitch);
  for (int row = 1; row < 20; ++row) {
    for (int col = 1; col < 20; ++col) {
      const Eigen::Vector2d p = extent.place(row, col);
      const Eigen::Vector3d truth(0.4 * p.x() - 0.1 * p.y(), -0.1 * p.x(), 1.0);
      EXPECT_LT((normals(row, col).cast<double>() - truth.normalized()).norm(), 1e-6);
    }
  }
}

TEST(NormalsOf, NeverReadOutsideTheMask) {
  const Extent extent{5, 5, 1.0, Unit::px};
  Mask mask(5, 5, 0);
  mask(2, 2) = mask(2, 3) = mask(0, 0) = 1;
  Grid<float> height(5, 5, nowhere);
  height(2, 2) = 1.0f;
  height(2, 3) = 2.0f;
  height(0, 0) = 7.0f;
  const auto normals = normals_of(height, mask, extent.pitch);
  const float root_half = std::sqrt(0.5f);
  EXPECT_LT((normals(2, 2) - Eigen::Vector3f(-root_half, 0, root_half)).norm(), 1e-6f);
  EXPECT_LT((normals(2, 3) - Eigen::Vector3f(-root_half, 0, root_half)).norm(), 1e-6f);
  EXPECT_EQ(normals(0, 0), Eigen::Vector3f::UnitZ());  // alone: nothing says that it is tilted
  EXPECT_EQ(normals(4, 4), Eigen::Vector3f::UnitZ());
}

}  // namespace
}  // namespace hada
