#include "fit/block_fibres.h"

#include <gtest/gtest.h>

#include "tests/fit/made_block.h"

namespace hada {
namespace {

TEST(BlockFibres, TurnAsTheTangentialFaceShows) {
  const auto truth = made_stem();
  GrowthSolid solid;
  solid.frame = {{truth.pith_mm[0], truth.pith_mm[1]}, truth.lobes};
  solid.lean = {truth.pith_lean[0], truth.pith_lean[1]};
  solid.taper = truth.taper;
  solid.radii = truth.ring_radii_mm;
  Fit<Wood<>> wood;
  wood.material.ring_radii_mm = truth.ring_radii_mm;
  wood.sigma.ring_radii_mm.assign(truth.ring_radii_mm.size(), 0.0);
  add_turning(wood, solid, made_faces());
  EXPECT_NEAR(wood.material.spiral, truth.spiral, 0.01);
}

TEST(BlockFibres, AreMissedWithARemarkWhereNoFaceRunsAlongTheStem) {
  auto faces = made_faces();
  faces.pop_back();
  Fit<Wood<>> wood;
  add_turning(wood, GrowthSolid{}, faces);
  EXPECT_FALSE(wood.remarks.empty());
}

}  // namespace
}  // namespace hada
