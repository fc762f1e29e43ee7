#include "sheet/crossing.h"

#include <gtest/gtest.h>

#include "tests/sheet/patterns.h"

namespace hada {
namespace {

// Three panels; the middle one lies, the first stands at its left end, and the third, which is 3
// long, comes back over the middle at the height that its end has.
Sheet wound(double end_x, double end_z) {
  Sheet sheet = sheet_of(strip(3, Crease::valley), "strip");
  for (std::size_t v = 0; v < sheet.folded.size(); ++v) {
    const double y = sheet.flat[v].y();
    const int panel = int(sheet.flat[v].x() + 0.5);
    if (panel == 0) sheet.folded[v] = {1.0, y, 1.0};
    if (panel == 3) sheet.folded[v] = {end_x, y, end_z};
  }
  return sheet;
}

TEST(CrossingFaces, AreThoseThatReachThroughEachOther) {
  EXPECT_TRUE(crossing_faces(wound(3.0, 0.0)).empty());
  EXPECT_TRUE(crossing_faces(wound(1.5, 0.5)).empty());   // it ends before the wall
  EXPECT_TRUE(crossing_faces(wound(0.0, 3.0)).empty());   // it passes above: 1.5 at the wall
  const auto crossing = crossing_faces(wound(0.5, 0.5));  // through the wall at a third
  ASSERT_EQ(crossing.size(), 1u);
  const Sheet sheet = wound(0.5, 0.5);
  for (const int face : crossing[0]) {
    double x = 0.0;
    for (const int v : sheet.corners_of(face)) x += sheet.flat[std::size_t(v)].x() / 4.0;
    EXPECT_TRUE(x < 1.0 || x > 2.0);  // not the one between
  }
}

TEST(CrossingFaces, ByLessThanTheToleranceTouch) {
  const Sheet sheet = wound(1.0 - 1e-4, 0.5);
  EXPECT_EQ(crossing_faces(sheet, 1e-5).size(), 1u);
  EXPECT_TRUE(crossing_faces(sheet, 1e-3).empty());
}

}  // namespace
}  // namespace hada
