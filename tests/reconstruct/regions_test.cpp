#include "reconstruct/regions.h"

#include <gtest/gtest.h>

namespace hada {
namespace {

TEST(Regions, JoinAlongEdgesButNotAcrossCorners) {
  Mask mask(3, 4, 0);
  mask(0, 0) = mask(0, 1) = mask(1, 1) = 1;  // an L
  mask(2, 2) = mask(2, 3) = 1;               // touches it at a corner
  const Regions regions = regions_of(mask);
  EXPECT_EQ(regions.size, (std::vector<int>{7, 3, 2}));
  EXPECT_EQ(regions.label(0, 0), regions.label(1, 1));
  EXPECT_NE(regions.label(1, 1), regions.label(2, 2));
  EXPECT_EQ(regions.label(0, 3), 0);
}

}  // namespace
}  // namespace hada
