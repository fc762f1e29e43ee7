#include "fit/ridge_sheets.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

const Extent extent{96, 96, 0.2, Unit::mm};
const Wrinkle<> plain{.components = {{0.3, 1.0, 0.7, 0.5}}, .floor_mm4 = 1e-8};

TEST(RidgeSheets, AreTheSameWhetherTheyAreKept) {
  const RidgeSheets none(plain, extent, 0, 0), two(plain, extent, 0, 2);
  const Ridges ridges(0.2, 0.1, 1.0);
  EXPECT_EQ(none.moments(0, 3, ridges), two.moments(0, 3, ridges));
  EXPECT_EQ(two.mean(ridges), two.moments(0, 2, ridges).rowwise().mean());
  EXPECT_EQ(two.moments(0, 3, ridges).col(2), two.moments(2, 1, ridges).col(0));
}

TEST(RidgeSheets, HaveTheSameLuckUnderEveryRidge) {
  // So that a step of the ridges shows although it is smaller than the scatter of the sheets.
  const RidgeSheets sheets(plain, extent, 0, 4);
  const auto before = sheets.moments(0, 4, Ridges(0.1, 0.0, 0.0));
  const auto after = sheets.moments(0, 4, Ridges(0.15, 0.0, 0.0));
  for (int k = 0; k < 4; ++k) EXPECT_GT(after(height_skew, k), before(height_skew, k) + 0.02) << k;
}

TEST(RidgeSheets, AreDifferentOnes) {
  const auto moments = RidgeSheets(plain, extent, 0, 0).moments(0, 2, Ridges::Zero());
  EXPECT_NE(moments.col(0), moments.col(1));
}

}  // namespace
}  // namespace hada
