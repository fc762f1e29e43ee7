#include "mechanics/facet_springs.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hada {
namespace {

using Eigen::Vector3d;

TEST(FacetSprings, JoinAllCornersOfAFaceOnce) {
  const std::vector<Vector3d> places{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}};
  const auto springs = facet_springs({{0, 1, 2, 3}, {1, 4, 2}}, places);
  EXPECT_EQ(springs.size(), 8u);  // six of the square, three of the triangle, one in common
}

TEST(SpringMotion, FollowsTheRecurrenceOfOneSpring) {
  // Two points, one spring: the stretch e obeys v += -d v - 2 d e, e += v.
  SpringMotion motion({{0, 1, 1.0}}, {{0, 0, 0}, {1.1, 0, 0}}, {}, {});
  double stretch = 0.1, speed = 0.0;
  for (int i = 0; i < 50; ++i) {
    motion.step(1);
    speed += -0.2 * speed - 0.4 * stretch;
    stretch += speed;
    const auto places = motion.places();
    EXPECT_NEAR((places[1] - places[0]).norm() - 1.0, stretch, 1e-13);
  }
  EXPECT_EQ(motion.substeps(), 1);
  EXPECT_LT(std::abs(stretch), 0.01);
}

// A fan of n triangles around one point: n springs end there.
SpringMotion fan(int count, bool mass_by_springs) {
  std::vector<Vector3d> places{{0, 0, 0}};
  std::vector<std::vector<int>> faces;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * i / count;
    places.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    faces.push_back({0, 1 + i, 1 + (i + 1) % count});
  }
  auto springs = facet_springs(faces, places);
  places[0].z() = 0.2;
  places[1].x() += 0.1;
  return {springs, places, {}, {.damping = 0.2, .mass_by_springs = mass_by_springs}};
}

TEST(SpringMotion, TakesSmallStepsWhereManySpringsMeet) {
  for (const int count : {4, 24, 60}) {
    SpringMotion motion = fan(count, false);
    // The middle and its ring move against each other: lambda is about count / 2.
    EXPECT_GE(motion.substeps(), count == 60 ? 2 : 1);
    motion.step(4000);
    // Rising out of the plane shortens springs by the square of the height: the end is slow.
    EXPECT_LT(motion.strain(), 1e-4) << count;
  }
}

TEST(SpringMotion, NeedsNoSmallStepsWithMassBySprings) {
  SpringMotion motion = fan(60, true);
  EXPECT_EQ(motion.substeps(), 1);
  motion.step(8000);
  EXPECT_LT(motion.strain(), 1e-6);
}

TEST(SpringMotion, LeavesPinnedPointsAlone) {
  SpringMotion motion({{0, 1, 1.0}}, {{0, 0, 0}, {2, 0, 0}}, {true, false}, {});
  motion.step(500);
  EXPECT_EQ(motion.places()[0], Vector3d(0, 0, 0));
  EXPECT_NEAR(motion.places()[1].x(), 1.0, 1e-9);
}

}  // namespace
}  // namespace hada
