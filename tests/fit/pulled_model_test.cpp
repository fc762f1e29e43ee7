#include "fit/pulled_model.h"

#include <gtest/gtest.h>

#include "mechanics/knit_rest.h"

namespace hada {
namespace {

TEST(PulledModel, KnowsHowItChangesWithEveryParameter) {
  KnitNet net;
  net.courses = 6, net.wales = 7;
  net.wale_length = 2.0, net.course_length = 1.5;
  net.stiffness = stiffness_of_courses(6, 8.0);
  const auto knit = pulled(net, KnitPull::wale, KnitClamp::three_points, 1.3);
  const Places seen = knit_at_rest(knit.net, knit.start).places;
  const std::vector<KnitState> states{{KnitPull::wale, 1.3, seen}};
  PulledModel model(net, {0, 1}, KnitClamp::three_points, states,
                    {.lengths_known = false, .frame_known = false});
  ASSERT_EQ(model.parameters(), 8);
  ASSERT_EQ(model.residuals(), 84);  // those that are held tell of the frame
  const std::vector<double> p{std::log(6.0), 0.25, 0.02, -0.03, 0.05, -0.1, 0.4, -0.2};
  std::vector<double> at(84), slopes(84 * 8), up(84), down(84);
  model.evaluate(p.data(), at.data(), slopes.data());
  for (int k = 0; k < 8; ++k) {
    auto ahead = p, behind = p;
    const double step = 1e-4;
    ahead[std::size_t(k)] += step, behind[std::size_t(k)] -= step;
    model.evaluate(ahead.data(), up.data(), nullptr);
    model.evaluate(behind.data(), down.data(), nullptr);
    for (std::size_t i = 0; i < 84; ++i) {
      // The search for the rest ends within 1e-8, over the step; and step^2 of third derivatives.
      EXPECT_NEAR(slopes[i * 8 + std::size_t(k)], (up[i] - down[i]) / (2.0 * step), 3e-4) << k;
    }
  }
}

TEST(PulledModel, LeavesOutWhatWasNotSeenOrIsHeld) {
  KnitNet net;
  net.courses = net.wales = 5;
  net.stiffness = stiffness_of_courses(5, 10.0);
  auto knit = pulled(net, KnitPull::wale, KnitClamp::uniform, 1.2);
  knit.start[12].setConstant(NAN);
  const std::vector<KnitState> states{{KnitPull::wale, 1.2, knit.start}};
  const PulledModel model(net, {0, 1}, KnitClamp::uniform, states, {});
  EXPECT_EQ(model.parameters(), 2);
  EXPECT_EQ(model.residuals(), 2 * (25 - 10 - 1));
}

}  // namespace
}  // namespace hada
