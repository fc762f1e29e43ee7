#include "fit/block.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/fit/made_block.h"

namespace hada {
namespace {

TEST(Block, FindsLeanAndTaperFromTwoFaces) {
  const auto block = fit_block(made_faces());
  const auto &found = block.wood.material, &sigma = block.wood.sigma;
  const auto truth = made_stem();
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

TEST(Block, NeedsAnEndGrain) {
  auto given = made_faces();
  given.erase(given.begin());
  EXPECT_THROW(fit_block(given), Error);
}

}  // namespace
}  // namespace hada
