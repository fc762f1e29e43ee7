#include "synth/bent_knit.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace hada {
namespace {

// Places that are linear in wale and course, but for one that is pulled aside.
BentKnit sheared(int courses, int wales, double aside = 0.0) {
  BentKnit bent{courses, wales, {}};
  for (int j = 0; j < courses; ++j) {
    for (int i = 0; i < wales; ++i) bent.places.emplace_back(2.0 * i + 0.3 * j, 1.5 * j, 0.0);
  }
  bent.places[std::size_t(2 * wales + 2)].x() += aside;
  return bent;
}

TEST(BentKnit, RunsEvenlyThroughEvenCrossingsAndBeyondThem) {
  const BentKnit bent = sheared(5, 6);
  for (const double wale : {-0.9, 0.0, 1.3, 4.99, 5.8}) {
    for (const double course : {-0.7, 0.5, 3.0, 4.6}) {
      const Eigen::Vector2d truth(2.0 * wale + 0.3 * course, 1.5 * course);
      // Sums of sixteen roundings of numbers around ten.
      EXPECT_NEAR((bent.straight(wale, course) - truth).norm(), 0.0, 1e-13);
      EXPECT_NEAR((bent.smooth(wale, course) - truth).norm(), 0.0, 1e-13);
    }
  }
}

TEST(BentKnit, PassesThroughCrossingsThatLieAside) {
  const BentKnit bent = sheared(5, 6, 0.4);
  EXPECT_NEAR(bent.smooth(2.0, 2.0).x(), 5.0, 1e-13);
  EXPECT_NEAR(bent.straight(2.5, 2.0).x(), 5.8, 1e-13);
  // A cubic of Catmull and Rom half way: 9/16 of either neighbour, -1/16 of those beyond.
  EXPECT_NEAR(bent.smooth(2.5, 2.0).x(), 5.6 + 0.4 * 9.0 / 16.0, 1e-13);
  EXPECT_NEAR(bent.smooth(3.5, 2.0).x(), 7.6 - 0.4 / 16.0, 1e-13);
}

TEST(BentKnit, NumbersTheLoopsOfItsCrossings) {
  const BentKnit bent = sheared(3, 4);
  Knit<> knit;
  knit.wale_mm = 2.0, knit.course_mm = 1.5, knit.yarn_radius_mm = 0.3;
  const Extent extent{100, 100, 0.1, Unit::mm};
  const auto points = bent_loops(knit, bent, extent, &BentKnit::smooth);
  ASSERT_EQ(points.size() % 12, 0u);
  EXPECT_EQ(points.front().course, 0);
  EXPECT_EQ(points.back().course, 11);
  // Half way along a loop is its head, over the crossing by the reach.
  const std::size_t of_loop = points.size() / 12;
  const auto& head = points[5 * of_loop + of_loop / 2];
  const Eigen::Vector2d there = extent.place(head.row, head.col);
  const double course = 1.0 + knit.loop_reach;
  EXPECT_NEAR(there.x(), 2.0 * 1.0 + 0.3 * course, 0.05);  // of one point to the next
  EXPECT_NEAR(there.y(), 1.5 * course, 0.05);
  EXPECT_THROW(bent_loops(knit, {3, 3, bent.places}, extent, &BentKnit::smooth), Error);
}

}  // namespace
}  // namespace hada
