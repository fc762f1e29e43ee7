#include "fit/ring_following.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/fit/dark_lines.h"

namespace hada {
namespace {

const Extent extent{160, 160, 1.0, Unit::px};
const SolidPrior prior{.pith = 30.0, .lean = 0.08, .taper = 0.04};

/// What an end grain at z = 0 says that does not show the last ring.
GrowthSolid start() {
  GrowthSolid solid = far_stem();
  solid.lean = {0.0, -0.12};
  solid.radii.pop_back();
  solid.covariance = 0.25 * Eigen::MatrixXd::Identity(solid.size(), solid.size());
  solid.covariance.block<2, 2>(2, 2) = 0.0064 * Eigen::Matrix2d::Identity();
  solid.covariance(4, 4) = 0.0016;
  return solid;
}

TEST(RingFollowing, GoesDownTheFacesAndTakesUpRings) {
  const GrowthSolid stem = far_stem();
  const std::vector<BlockFace> faces = {
      dark_lines(stem, stem.radii, Cut(), extent),
      dark_lines(stem, stem.radii, cut_along({-80, 0, 80}, {0, -1, 0}, {0, 0, 1}), extent),
      dark_lines(stem, stem.radii, cut_along({80, 0, 80}, {0, 1, 0}, {0, 0, 1}), extent)};
  const Followed followed = followed_rings(faces, start(), prior, RingMark::line, 0.3);
  ASSERT_EQ(followed.solid.radii.size(), stem.radii.size());
  // Rings of the solid against the true ones, at the head of a face: a pixel of 22 from ring to
  // ring.
  for (const double y : {-40.0, 0.0, 40.0}) {
    const StemVector place{-80.0, y, 150.0};
    const double off = local_of(followed.solid, place).rho - local_of(stem, place).rho;
    EXPECT_NEAR(off - (followed.solid.radii[4] - stem.radii[4]), 0.0, 1.0);
  }
}

TEST(RingFollowing, NeedsRings) {
  const std::vector<BlockFace> faces = {dark_lines(far_stem(), {}, Cut(), {8, 8, 1.0, Unit::px})};
  EXPECT_THROW(followed_rings(faces, start(), prior, RingMark::line, 0.3), Error);
}

}  // namespace
}  // namespace hada
