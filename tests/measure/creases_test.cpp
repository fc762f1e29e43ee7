#include "measure/creases.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"

namespace hada {
namespace {

using Eigen::Vector2d;

constexpr double degree = std::numbers::pi / 180.0;

// Planes z = slope . p that meet along straight lines through `on`: the lowest slope wins on a
// ridge (min), the highest in a valley (max).
struct Bend {
  Vector2d normal;  // from the first plane to the second
  double offset;
  double fold_deg;  // valley > 0
};

// A sheet with one bend: slopes +-tan(fold / 2) across the line, so that the fold is exact.
Surface bent_sheet(const Bend& bend, const Extent& extent, double noise_deg, Seed seed) {
  Surface surface;
  surface.extent = extent;
  surface.mask = full_mask(extent);
  surface.normals = NormalMap(extent.rows, extent.cols, Eigen::Vector3f::UnitZ());
  const double half = std::tan(0.5 * bend.fold_deg * degree);
  for (int row = 0; row < extent.rows; ++row) {
    for (int col = 0; col < extent.cols; ++col) {
      Vector2d slope = Vector2d::Zero();
      constexpr int finer = 8;
      for (int k = 0; k < finer * finer; ++k) {
        const Vector2d p = extent.place(row + (k / finer + 0.5) / finer - 0.5,
                                        col + (k % finer + 0.5) / finer - 0.5);
        slope += (bend.normal.dot(p) > bend.offset ? half : -half) * bend.normal / (finer * finer);
      }
      slope.x() += std::tan(noise_deg * degree) * gaussian(seed, row, col, 0);
      slope.y() += std::tan(noise_deg * degree) * gaussian(seed, row, col, 1);
      surface.normals(row, col) =
          Eigen::Vector3d(-slope.x(), -slope.y(), 1.0).normalized().cast<float>();
    }
  }
  return surface;
}

Vector2d towards(double deg) {
  return {std::cos(deg * degree), std::sin(deg * degree)};
}

TEST(Creases, OfOneBendAreWhereItIs) {
  const Extent extent{200, 240, 0.5, Unit::mm};
  for (const Bend& bend : {Bend{towards(20), 7.3, 12.0}, Bend{towards(100), -3.1, -4.0}}) {
    const auto found = measured_creases(bent_sheet(bend, extent, 0.0, 1));
    ASSERT_EQ(found.creases.size(), 1u);
    const MeasuredCrease& crease = found.creases[0];
    // Floats of normals, and facets averaged over a band beside the crease only.
    EXPECT_NEAR(crease.fold_angle / degree, bend.fold_deg, 1e-3);
    for (const Vector2d& end : {crease.from, crease.to}) {
      EXPECT_NEAR(bend.normal.dot(end), bend.offset, 0.02 * extent.pitch);
    }
    EXPECT_EQ(found.frame.edges.size(), 7u);  // the crease, four sides, two of them cut in two
  }
}

TEST(Creases, OfRoughPaperAreKnownAsWellAsTheySay) {
  const Extent extent{200, 240, 0.5, Unit::mm};
  int within = 0, all = 0;
  for (Seed seed = 0; seed < 10; ++seed) {
    const Bend bend{towards(30 + 20 * double(seed)), 4.0, seed % 2 ? 8.0 : -8.0};
    const auto found = measured_creases(bent_sheet(bend, extent, 3.0, seed));
    ASSERT_EQ(found.creases.size(), 1u) << seed;
    const MeasuredCrease& crease = found.creases[0];
    const double error = crease.fold_angle - bend.fold_deg * degree;
    // 3 degrees over some 20000 pixels of a facet: 0.03 degrees; four sigmas.
    EXPECT_LT(std::abs(error), 0.12 * degree);
    within += std::abs(error) < 2.0 * crease.fold_angle_sigma;
    ++all;
  }
  EXPECT_GE(within, all - 2);  // 95 % of ten
}

TEST(Creases, ThatAreTwoDegreesDeepAreFound) {
  const Extent extent{240, 240, 0.5, Unit::mm};
  const auto found = measured_creases(bent_sheet({towards(75), 2.0, 2.0}, extent, 1.0, 5));
  ASSERT_EQ(found.creases.size(), 1u);
  EXPECT_NEAR(found.creases[0].fold_angle / degree, 2.0, 0.1);
}

TEST(Creases, AskForNormals) {
  Surface surface;
  surface.extent = {10, 10, 1.0, Unit::px};
  surface.mask = full_mask(surface.extent);
  EXPECT_THROW(measured_creases(surface), Error);
}

}  // namespace
}  // namespace hada
