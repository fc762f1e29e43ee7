#include "synth/cut.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace hada {
namespace {

TEST(Cut, IsMadeOfUnitVectorsAtRightAnglesAndKeepsItsRight) {
  const Cut cut = cut_along({1.0, 2.0, 3.0}, {0.0, 2.0, 0.0}, {0.0, 0.5, 4.0});
  EXPECT_EQ(cut.right, (StemVector{0.0, 1.0, 0.0}));
  EXPECT_EQ(cut.up, (StemVector{0.0, 0.0, 1.0}));
  EXPECT_EQ(cut.towards_eye(), (StemVector{1.0, 0.0, 0.0}));
  EXPECT_EQ(cut.at(0.0, 0.0), (StemVector{1.0, 2.0, 3.0}));
  EXPECT_EQ(cut.at(2.0, -1.0), (StemVector{1.0, 4.0, 2.0}));
}

TEST(Cut, RefusesDirectionsThatSpanNoPlane) {
  EXPECT_THROW(cut_along({0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {-2.0, -2.0, 0.0}), Error);
  EXPECT_THROW(cut_along({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}), Error);
}

}  // namespace
}  // namespace hada
