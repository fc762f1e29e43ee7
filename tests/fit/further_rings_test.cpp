#include "fit/further_rings.h"

#include <gtest/gtest.h>

#include "tests/fit/dark_lines.h"

namespace hada {
namespace {

const Extent extent{200, 200, 1.0, Unit::px};

/// Faces of a stem with all of its rings; `solid` is left without some of them.
std::vector<BlockFace> faces(const GrowthSolid& solid) {
  return {dark_lines(solid, solid.radii, Cut(), extent),
          dark_lines(solid, solid.radii, cut_along({-100, 0, 0}, {0, -1, 0}, {0, 0, 1}), extent)};
}

GrowthSolid without(GrowthSolid solid, const std::vector<std::size_t>& rings) {
  for (auto ring = rings.rbegin(); ring != rings.rend(); ++ring)
    solid.radii.erase(solid.radii.begin() + std::ptrdiff_t(*ring));
  solid.covariance = 1e-4 * Eigen::MatrixXd::Identity(solid.size(), solid.size());
  solid.covariance.block<2, 2>(2, 2) *= 1e-4;  // of the lean
  solid.covariance(4, 4) *= 1e-4;
  return solid;
}

TEST(FurtherRings, AreThoseThatAreMissing) {
  const auto found = further_rings(faces(far_stem()), without(far_stem(), {3, 7}));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], 330.0 + 3 * 22.0, 1.0);  // bins are 0.9 wide
  EXPECT_NEAR(found[1], 330.0 + 7 * 22.0, 1.0);
}

TEST(FurtherRings, AreNoneWhereAllAreKnown) {
  EXPECT_TRUE(further_rings(faces(far_stem()), without(far_stem(), {})).empty());
}

TEST(FurtherRings, AreNoneWhereItIsNotKnownWhereTheyAre) {
  auto solid = without(far_stem(), {3, 7});
  solid.covariance *= 1e6;  // pith to 10 px: half a ring
  EXPECT_TRUE(further_rings(faces(far_stem()), solid).empty());
}

}  // namespace
}  // namespace hada
