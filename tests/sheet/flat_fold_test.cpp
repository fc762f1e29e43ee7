#include "sheet/flat_fold.h"

#include <gtest/gtest.h>

#include "tests/sheet/patterns.h"

namespace hada {
namespace {

TEST(FlatFold, StacksAStrip) {
  const Sheet sheet = sheet_of(strip(5, Crease::valley), "strip");
  const FlatState state = flat_state(sheet);
  EXPECT_LT(state.gap, 1e-15);
  // A vertex at x lands at the distance that a zigzag of step 1 is from its start, or mirrored.
  double low = 1e9, high = -1e9;
  for (const auto& p : state.vertices) {
    low = std::min(low, p.x());
    high = std::max(high, p.x());
  }
  EXPECT_NEAR(high - low, 1.0, 1e-15);
  int turned = 0;
  for (const bool t : state.turned) turned += t;
  EXPECT_EQ(std::min(turned, 5 - turned), 2);
}

TEST(FlatFold, MeasuresHowFarFacesDisagree) {
  const Sheet good = sheet_of(vertex_fold({0, 60, 180, 300}, "MVVV"), "good");
  EXPECT_LT(flat_state(good).gap, 1e-15);
  // Alternate angles 170 and 190: going around turns the paper by 20 degrees, and the border is at
  // least 1 away from the vertex: 2 sin(10 deg) = 0.35.
  const Sheet bad = sheet_of(vertex_fold({0, 50, 180, 300}, "MVVV"), "bad");
  EXPECT_GT(flat_state(bad).gap, 0.34);
}

}  // namespace
}  // namespace hada
