#include "fit/block_cut.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/fit/made_block.h"

namespace hada {
namespace {

TEST(BlockCut, PredictsASlantedCut) {
  const auto block = fit_block(made_faces());
  const Cut slanted = cut_along({4.0, -3.0, 8.0}, {0.0, 1.0, 0.0}, {0.6, 0.0, 1.0});
  const Extent extent{300, 300, 0.1, Unit::mm};
  const auto cut = predicted(block, slanted, extent);
  ASSERT_GT(cut.rings.size(), 300u);
  const auto truth = made_stem();
  GrowthSolid real;
  real.frame = {{truth.pith_mm[0], truth.pith_mm[1]}, truth.lobes};
  real.lean = {truth.pith_lean[0], truth.pith_lean[1]};
  real.taper = truth.taper;
  int inside = 0;
  for (const RingStation& station : cut.rings) {
    const double rho = local_of(real, slanted.at(station.place.x(), station.place.y()), false).rho;
    double off = HUGE_VAL;
    for (const double radius : truth.ring_radii_mm) off = std::min(off, std::abs(rho - radius));
    EXPECT_LT(off, 0.1);  // a pixel
    if (off / station.slope <= 1.645 * station.sigma) ++inside;
  }
  EXPECT_GT(inside, 0.8 * double(cut.rings.size()));
  // Fibres turn by 0.08 around the stem, whose radius this cut goes up along by 0.6.
  EXPECT_GT(cut.mean_slope.sigma, 0.0);
  EXPECT_LT(std::abs(cut.mean_slope.value), 0.15);
}

TEST(BlockCut, SaysThatAFaceMissesWhereItIsNotKnownWhereRingsAre) {
  auto given = made_faces();
  given.pop_back();
  const auto block = fit_block(given);
  const auto cut = predicted(block, face_cut, {300, 300, 0.1, Unit::mm});
  double near = 0.0, far = 0.0;
  for (const RingStation& station : cut.rings) {
    double& widest = std::abs(station.place.y()) < 1.0 ? near : far;
    widest = std::max(widest, station.sigma);
  }
  EXPECT_GT(far, 4.0 * near);  // nothing is known of lean and taper
}

}  // namespace
}  // namespace hada
