#include "mechanics/knit_motion.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "mechanics/knit_pull.h"

namespace hada {
namespace {

PulledKnit patch() {
  KnitNet net;
  net.courses = net.wales = 10;
  net.stiffness = stiffness_of_courses(10, 10.0);
  return pulled(net, KnitPull::wale, KnitClamp::uniform, 1.5);
}

TEST(KnitMotion, SettlesThePapersPatchInAboutAHundredSteps) {
  const auto knit = patch();
  const auto motion = knit_motion(knit.net, knit.start);
  EXPECT_GE(motion.motion.size(), 80u);
  EXPECT_LE(motion.motion.size(), 120u);
  EXPECT_LT(motion.motion.back(), 1e-3);
}

TEST(KnitMotion, EndsWhereTensionIsTheSameAlongEveryWale) {
  const auto knit = patch();
  const auto motion = knit_motion(knit.net, knit.start, {.still = 1e-12});
  const auto springs = springs_of(knit.net, motion.places);
  // In series: 5 of nylon and 4 of support yarn share 4.5 of stretch, 5 T + 4 T / 10 = 4.5.
  for (std::size_t i = 0; i < 90; ++i) EXPECT_NEAR(springs.up_tension[i], 4.5 / 5.4, 1e-9);
}

TEST(KnitMotion, RefusesSpringsThatItsStepsCannotFollow) {
  auto knit = patch();
  knit.net.stiffness.assign(10, 100.0);
  EXPECT_THROW(knit_motion(knit.net, knit.start), Error);
}

}  // namespace
}  // namespace hada
