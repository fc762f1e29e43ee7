#include "fit/growth_solid.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

GrowthSolid leaning() {
  GrowthSolid solid;
  solid.frame = {{-3.0, 2.0}, {{2.0, 0.04, -0.03}}};
  solid.lean = {0.02, -0.03};
  solid.taper = 0.015;
  solid.ripples = Ripples({{-20.0, -20.0, -20.0}, {40.0, 40.0, 40.0}}, {{1, 0, 2}, {2, 1, 0}});
  solid.ripples.heights = {0.1, -0.05};
  solid.radii = {2.0, 4.5, 6.0};
  return solid;
}

TEST(GrowthSolid, ComesBackFromItsState) {
  const GrowthSolid solid = leaning();
  GrowthSolid other = solid;
  other.set_state(Eigen::VectorXd::Zero(solid.size()));
  other.set_state(solid.state());
  EXPECT_EQ(other.state(), solid.state());
  EXPECT_EQ(other.radii, solid.radii);
  EXPECT_EQ(other.lean, solid.lean);
}

TEST(GrowthSolid, KnowsHowItsRadiusChanges) {
  const GrowthSolid solid = leaning();
  const StemVector place{7.0, -4.0, 9.0};
  const SolidLocal local = local_of(solid, place);
  // Differences over 2e-6 of numbers near 10: good to 1e-9 by rounding, and by their cubes.
  constexpr double step = 1e-6;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    StemVector ahead = place, behind = place;
    ahead[axis] += step, behind[axis] -= step;
    EXPECT_NEAR(local.gradient[Eigen::Index(axis)],
                (local_of(solid, ahead).rho - local_of(solid, behind).rho) / (2.0 * step), 1e-7);
  }
  for (Eigen::Index k = 0; k < solid.radii_at(); ++k) {
    GrowthSolid ahead = solid, behind = solid;
    ahead.set_state(solid.state() + step * Eigen::VectorXd::Unit(solid.size(), k));
    behind.set_state(solid.state() - step * Eigen::VectorXd::Unit(solid.size(), k));
    EXPECT_NEAR(local.slopes[k],
                (local_of(ahead, place).rho - local_of(behind, place).rho) / (2.0 * step), 1e-7)
        << k;
  }
}

TEST(GrowthSolid, IsAsSureOfARingAsItsCovarianceSays) {
  GrowthSolid solid = leaning();
  solid.covariance = Eigen::MatrixXd::Zero(solid.size(), solid.size());
  solid.covariance(solid.radii_at() + 1, solid.radii_at() + 1) = 0.04;
  solid.covariance(4, 4) = 0.0001;  // of the taper, which moves rho by z
  const SolidLocal local = local_of(solid, {7.0, -4.0, 9.0});
  EXPECT_NEAR(ring_sigma(solid, local, 1), std::hypot(0.2, 0.09), 1e-12);
  EXPECT_NEAR(rho_sigma(solid, local), 0.09, 1e-12);
}

TEST(GrowthSolid, LaysFibresAlongTheRings) {
  // A straight stem whose fibres turn: on the tangential face at (r, 0, z) they lean by the
  // gradient.
  GrowthSolid solid;
  solid.frame.pith = {0.0, 0.0};
  const Cut face = cut_along({10.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});
  EXPECT_NEAR(fibre_slope(solid, face, {0.0, 5.0}, 0.1), 0.1, 1e-12);
}

}  // namespace
}  // namespace hada
