#include "fit/ring_sightings.h"

#include <gtest/gtest.h>

#include "tests/fit/dark_lines.h"

namespace hada {
namespace {

/// A stem that is known to half a px, but for its pith, which is taken for 1 px beside.
GrowthSolid nearly_known(double pith_sigma) {
  GrowthSolid solid = far_stem();
  solid.frame.pith.y() -= 1.0;
  solid.covariance = Eigen::MatrixXd::Zero(solid.size(), solid.size());
  solid.covariance.topLeftCorner<2, 2>() = pith_sigma * pith_sigma * Eigen::Matrix2d::Identity();
  return solid;
}

TEST(RingSightings, AreWhereTheLinesAreAndNotWhereTheyAreExpected) {
  const Extent extent{160, 160, 1.0, Unit::px};
  const GrowthSolid truth = far_stem();
  const auto seen = ring_sightings(dark_lines(truth, truth.radii, Cut(), extent), 2,
                                   nearly_known(0.5), RingMark::line, 0.5);
  ASSERT_GT(seen.size(), 100u);
  double square = 0.0;
  for (const RingSighting& one : seen) {
    EXPECT_EQ(one.face, 2u);
    const double off = local_of(truth, one.place, false).rho - truth.radii[one.ring];
    square += off * off / double(seen.size());
  }
  // Expected 1 px beside; a line of 2.5 px in noise of a fifteenth of it, over 19 offsets along.
  EXPECT_LT(std::sqrt(square), 0.3);
}

TEST(RingSightings, AreNoneWhereARingCouldBeTakenForItsNeighbour) {
  const GrowthSolid truth = far_stem();
  const auto face = dark_lines(truth, truth.radii, Cut(), {160, 160, 1.0, Unit::px});
  EXPECT_TRUE(ring_sightings(face, 0, nearly_known(8.0), RingMark::line, 0.5).empty());
}

}  // namespace
}  // namespace hada
