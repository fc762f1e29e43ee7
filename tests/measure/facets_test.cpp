#include "measure/facets.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace hada {
namespace {

using Eigen::Vector2d;

// Planes of these slopes, side by side in x, and noise of each slope.
Surface panels(const std::vector<Vector2d>& slopes, double noise, Seed seed) {
  Surface surface;
  surface.extent = {180, 80 * int(slopes.size()), 0.25, Unit::mm};
  surface.mask = full_mask(surface.extent);
  surface.normals = NormalMap(surface.extent.rows, surface.extent.cols, Eigen::Vector3f::UnitZ());
  for (int row = 0; row < surface.extent.rows; ++row) {
    for (int col = 0; col < surface.extent.cols; ++col) {
      const Vector2d slope =
          slopes[std::size_t(col / 80)] +
          noise * Vector2d(gaussian(seed, row, col, 0), gaussian(seed, row, col, 1));
      surface.normals(row, col) =
          Eigen::Vector3d(-slope.x(), -slope.y(), 1.0).normalized().cast<float>();
    }
  }
  return surface;
}

TEST(Facets, AreThePlanesThatAreThere) {
  const std::vector<Vector2d> slopes{{0.10, 0.0}, {-0.05, 0.03}, {0.12, -0.02}};
  const double noise = 0.03;
  const Facets found = facets_of(panels(slopes, noise, 3));
  ASSERT_EQ(found.facets.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const int label = found.label(90, int(80 * k + 40));
    ASSERT_GE(label, 0);
    const Facet& facet = found.facets[std::size_t(label)];
    // Noise over the pixels that were averaged; four sigmas of two numbers.
    const double sigma = noise / std::sqrt(double(facet.pixels));
    EXPECT_LT((facet.slope - slopes[k]).norm(), 4.0 * std::sqrt(2.0) * sigma);
    EXPECT_GT(facet.sigma, 0.4 * sigma);
    EXPECT_LT(facet.sigma, 2.5 * sigma);
  }
  // Every pixel belongs to the panel that it lies on, but for those beside a crease.
  int wrong = 0;
  for (int row = 0; row < found.label.rows(); ++row) {
    for (int col = 0; col < found.label.cols(); ++col) {
      const bool beside = std::min(col % 80, 79 - col % 80) <= found.reach_px / 2;
      wrong += !beside && found.label(row, col) != found.label(90, col / 80 * 80 + 40);
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(Facets, ThatDifferByLessThanAskedAreOne) {
  const double fold = std::tan(3.0 * std::numbers::pi / 180.0);
  const Surface surface = panels({{0.0, 0.0}, {fold, 0.0}}, 0.005, 1);
  EXPECT_EQ(facets_of(surface).facets.size(), 2u);
  EXPECT_EQ(facets_of(surface, {.smallest_fold_deg = 8.0}).facets.size(), 1u);
}

TEST(Facets, NeedNormals) {
  Surface surface = panels({{0.0, 0.0}}, 0.0, 1);
  surface.normals = {};
  EXPECT_THROW(facets_of(surface), Error);
}

}  // namespace
}  // namespace hada
