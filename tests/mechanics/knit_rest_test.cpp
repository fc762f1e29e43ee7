#include "mechanics/knit_rest.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "mechanics/knit_motion.h"
#include "mechanics/knit_pull.h"

namespace hada {
namespace {

KnitNet net_of(int courses, int wales) {
  KnitNet net;
  net.courses = courses, net.wales = wales;
  net.stiffness = stiffness_of_courses(courses, 10.0);
  return net;
}

TEST(KnitRest, IsWhereThePapersMotionEnds) {
  for (const auto pull : {KnitPull::course, KnitPull::wale}) {
    for (const auto clamp : {KnitClamp::uniform, KnitClamp::three_points}) {
      const auto knit = pulled(net_of(10, 12), pull, clamp, 1.5);
      const auto rest = knit_at_rest(knit.net, knit.start);
      EXPECT_TRUE(rest.settled);
      EXPECT_LT(rest.force_left, 1e-9);
      const auto motion = knit_motion(knit.net, knit.start, {.still = 1e-12});
      // The slowest mode creeps by 1e-12 a step over some 1e3 steps.
      for (std::size_t i = 0; i < rest.places.size(); ++i) {
        EXPECT_LT((rest.places[i] - motion.places[i]).norm(), 1e-8);
      }
    }
  }
}

TEST(KnitRest, TakesFewStepsWhateverTheSize) {
  const auto knit = pulled(net_of(60, 60), KnitPull::course, KnitClamp::uniform, 1.5);
  EXPECT_LE(knit_at_rest(knit.net, knit.start).steps, 5);
}

TEST(KnitRest, SettlesWhereOnlyRoundingIsLeft) {
  const auto knit = pulled(net_of(10, 10), KnitPull::course, KnitClamp::uniform, 1.2);
  const auto rest = knit_at_rest(knit.net, knit.start);
  EXPECT_TRUE(rest.settled);
  EXPECT_TRUE(knit_at_rest(knit.net, rest.places).settled);
}

TEST(KnitRest, SaysThatItHasNotSettled) {
  const auto knit = pulled(net_of(10, 10), KnitPull::wale, KnitClamp::three_points, 1.5);
  EXPECT_FALSE(knit_at_rest(knit.net, knit.start, {.most_steps = 2}).settled);
}

TEST(KnitRest, ShrinksATubeToTheSizeThatItsEndsHave) {
  // A tube held at its ends on circles of the size of its rest keeps that size.
  KnitNet net = net_of(6, 12);
  net.round = true;
  Places start;
  const double radius = 0.5 / std::sin(M_PI / 12.0);
  for (int i = 0; i < net.points(); ++i) {
    const double turn = 2.0 * M_PI * (i % 12) / 12.0, bulge = i / 12 % 5 == 0 ? 1.0 : 1.2;
    start.emplace_back(bulge * radius * std::cos(turn), 1.1 * (i / 12),
                       bulge * radius * std::sin(turn));
    net.pinned.push_back(i / 12 % 5 == 0);
  }
  const auto rest = knit_at_rest(net, start);
  EXPECT_TRUE(rest.settled);
  for (const auto& place : rest.places) {
    EXPECT_NEAR(std::hypot(place.x(), place.z()), radius, 1e-6);
  }
}

TEST(KnitRest, RefusesANetWithoutItsPoints) {
  EXPECT_THROW(knit_at_rest(net_of(4, 4), Places(3)), Error);
  EXPECT_THROW(knit_at_rest(net_of(4, 2), Places(8)), Error);
}

}  // namespace
}  // namespace hada
