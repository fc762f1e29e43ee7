#include "fit/block.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "fit/block_cut.h"

namespace hada {
namespace {

const Cut end_cut, face_cut = cut_along({16.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});

Wood<> stem() {
  Wood<> wood;
  wood.pith_mm = {-3.0, 2.0};
  wood.pith_lean = {0.012, -0.02};
  wood.taper = 0.018;
  wood.lobes = {{2.0, 0.02, -0.03}, {3.0, 0.006, 0.004}};
  wood.spiral = 0.08;
  wood.fibre_shift = 0.2;
  wood.fibre_mm = 0.15;
  wood.ring_radii_mm.clear();
  double radius = 0.0;
  for (int k = 0; k < 24; ++k) wood.ring_radii_mm.push_back(radius += 1.6 + 1.2 * uniform(3, k));
  return wood;
}

/// A cut drawn twice as fine as it is looked at, with noise and 8 bits.
PlacedFace face_of(Wood<> wood, const char* name, const Cut& cut, int rows, int cols) {
  wood.cut_origin_mm.assign(cut.origin.begin(), cut.origin.end());
  wood.cut_right.assign(cut.right.begin(), cut.right.end());
  wood.cut_up.assign(cut.up.begin(), cut.up.end());
  const Surface fine = surface_of(wood, {2 * rows, 2 * cols, 0.05, Unit::mm}, 5);
  PlacedFace face{name, {}, cut};
  face.surface.extent = {rows, cols, 0.1, Unit::mm};
  face.surface.mask = full_mask(face.surface.extent);
  face.surface.albedo = Image(rows, cols, 3);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& from = fine.albedo.planes[c];
    for (int row = 0; row < rows; ++row) {
      for (int col = 0; col < cols; ++col) {
        double sum = 0.0;
        for (int k = 0; k < 4; ++k) sum += double(from(2 * row + k / 2, 2 * col + k % 2));
        const double noisy = 0.25 * sum + 0.01 * gaussian(77, row, col, int(c));
        face.surface.albedo.planes[c](row, col) = float(std::round(255.0 * noisy) / 255.0);
      }
    }
  }
  return face;
}

std::vector<PlacedFace> faces() {
  return {face_of(stem(), "end", end_cut, 420, 420), face_of(stem(), "face", face_cut, 500, 420)};
}

TEST(Block, FindsLeanAndTaperFromTwoFaces) {
  const auto block = fit_block(faces());
  const auto &found = block.wood.material, &sigma = block.wood.sigma;
  const auto truth = stem();
  // 25 mm of height, edges known to 0.01 mm at some hundred places: 1e-4 is ten of these sigmas.
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(found.pith_lean[k], truth.pith_lean[k], 0.001);
    EXPECT_NEAR(found.pith_lean[k], truth.pith_lean[k], 5.0 * sigma.pith_lean[k]);
    EXPECT_NEAR(found.pith_mm[k], truth.pith_mm[k], 0.02);
  }
  EXPECT_NEAR(found.taper, truth.taper, 0.001);
  EXPECT_NEAR(found.taper, truth.taper, 5.0 * sigma.taper);
  EXPECT_LT(sigma.taper, 0.001);
  EXPECT_NEAR(found.spiral, truth.spiral, 0.01);
}

TEST(Block, PredictsASlantedCut) {
  const auto block = fit_block(faces());
  const Cut slanted = cut_along({4.0, -3.0, 8.0}, {0.0, 1.0, 0.0}, {0.6, 0.0, 1.0});
  const Extent extent{300, 300, 0.1, Unit::mm};
  const auto cut = predicted(block, slanted, extent);
  ASSERT_GT(cut.rings.size(), 300u);
  const auto truth = stem();
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

TEST(Block, SaysThatAFaceMissesWhereItIsNotKnownWhereRingsAre) {
  auto given = faces();
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

TEST(Block, NeedsAnEndGrain) {
  auto given = faces();
  given.erase(given.begin());
  EXPECT_THROW(fit_block(given), Error);
}

}  // namespace
}  // namespace hada
