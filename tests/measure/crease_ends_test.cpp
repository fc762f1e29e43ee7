#include "measure/crease_ends.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

using Eigen::Vector2d;

const std::vector<Vector2d> sheet{{-10, -10}, {10, -10}, {10, 10}, {-10, 10}};

// A crease between two places that were seen.
CreaseCandidate seen(const Vector2d& from, const Vector2d& to) {
  CreaseCandidate candidate{0, 1, {}, 0.0, 0.0};
  const Vector2d way = (to - from).normalized();
  candidate.edge.normal = {way.y(), -way.x()};
  candidate.edge.offset = candidate.edge.normal.dot(from);
  candidate.from = along(candidate.edge).dot(from);
  candidate.to = along(candidate.edge).dot(to);
  return candidate;
}

TEST(CreaseEnds, LieOnTheOutlineWhereCreasesReachIt) {
  // It was seen up to a bit before the border, in a slanted direction.
  const CreaseEnds ends = ends_of({seen({-4.1, -9.5}, {3.9, 9.6})}, sheet, 1.0);
  ASSERT_EQ(ends.places.size(), 2u);
  EXPECT_NEAR(ends.places[0].y(), -10.0, 1e-12);
  EXPECT_NEAR(ends.places[1].y(), 10.0, 1e-12);
  EXPECT_EQ(ends.side, (std::vector<int>{0, 2}));
  // Along its own line.
  EXPECT_NEAR((ends.places[1] - ends.places[0]).normalized().dot(Vector2d(8.0, 19.1).normalized()),
              1.0, 1e-12);
}

TEST(CreaseEnds, ThatMeetShareTheirVertex) {
  // Four creases around (1, 2), each seen from half a unit beside it.
  const Vector2d middle(1.0, 2.0);
  std::vector<CreaseCandidate> creases;
  for (const Vector2d& end :
       {Vector2d(10, 3), Vector2d(2, 10), Vector2d(-10, 1), Vector2d(0, -10)}) {
    creases.push_back(seen(middle + 0.5 * (end - middle).normalized(), end));
  }
  const CreaseEnds ends = ends_of(creases, sheet, 1.0);
  EXPECT_EQ(ends.places.size(), 5u);
  for (const auto& of : ends.of) EXPECT_EQ(of[0], ends.of[0][0]);
  const std::size_t vertex = std::size_t(ends.of[0][0]);
  EXPECT_NEAR((ends.places[vertex] - middle).norm(), 0.0, 1e-12);
  EXPECT_EQ(ends.side[vertex], -1);
}

TEST(CreaseEnds, FarFromAllStayWhereTheyWereSeen) {
  const CreaseEnds ends = ends_of({seen({-3, 0}, {3, 0.5}), seen({-3, 5}, {3, 6})}, sheet, 1.0);
  ASSERT_EQ(ends.places.size(), 4u);
  EXPECT_NEAR((ends.places[0] - Vector2d(-3, 0)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace hada
