#include "synth/folded.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"

namespace hada {
namespace {

// A roof over a rectangle of 8 x 6, its ridge along y, its sides falling by `slope`.
FoldFrame roof(double slope) {
  FoldFrame frame;
  const double low = -4.0 * slope;
  frame.vertices = {{-4, -3, low}, {0, -3, 0}, {4, -3, low}, {4, 3, low}, {0, 3, 0}, {-4, 3, low}};
  frame.faces = {{0, 1, 4, 5}, {1, 2, 3, 4}};
  return frame;
}

TEST(FoldedSurface, HasTheHeightAndNormalsOfItsPlanes) {
  const Extent extent{80, 100, 0.1, Unit::mm};
  const Surface surface = folded_surface(roof(0.25), extent);
  double sum = 0.0;
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      const Eigen::Vector2d p = extent.place(row, col);
      const bool inside = std::abs(p.x()) < 4.0 && std::abs(p.y()) < 3.0;
      EXPECT_EQ(surface.mask(row, col) != 0, inside);
      if (!inside) continue;
      // Zero mean: the roof is 2 slope = 0.5 lower than its ridge on average. Floats.
      EXPECT_NEAR(surface.height(row, col), 0.5 - 0.25 * std::abs(p.x()), 1e-6);
      const double side = p.x() > 0.0 ? 0.25 : -0.25;
      const Eigen::Vector3d normal = Eigen::Vector3d(side, 0.0, 1.0).normalized();
      EXPECT_LT((surface.normals(row, col).cast<double>() - normal).norm(), 1e-6);
      sum += surface.height(row, col);
    }
  }
  EXPECT_NEAR(sum, 0.0, 1e-2);
}

TEST(FoldedSurface, RefusesWhatShowsItsBack) {
  FoldFrame turned = roof(0.25);
  std::swap(turned.faces[0][1], turned.faces[0][3]);
  EXPECT_THROW(folded_surface(turned, {10, 10, 1.0, Unit::mm}), Error);
  EXPECT_THROW(folded_surface(FoldFrame{}, {10, 10, 1.0, Unit::mm}), Error);
  FoldFrame away = roof(0.25);
  for (auto& p : away.vertices) p.x() += 100.0;
  EXPECT_THROW(folded_surface(away, {10, 10, 1.0, Unit::mm}), Error);
}

}  // namespace
}  // namespace hada
