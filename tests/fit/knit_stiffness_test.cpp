#include "fit/knit_stiffness.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "mechanics/knit_motion.h"
#include "mechanics/knit_rest.h"

namespace hada {
namespace {

KnitNet patch() {
  KnitNet net;
  net.courses = net.wales = 10;
  net.wale_length = 2.0, net.course_length = 1.5;
  return net;
}

// Crossings at rest by the paper's steps, which the fit does not take; seen with noise.
std::vector<KnitState> seen(KnitPull pull, KnitClamp clamp, double ratio, double noise_mm,
                            Seed seed) {
  KnitNet net = patch();
  net.stiffness = stiffness_of_courses(net.courses, ratio);
  std::vector<KnitState> states;
  for (const double stretch : {1.2, 1.5}) {
    const auto knit = pulled(net, pull, clamp, stretch);
    Places places = knit_motion(knit.net, knit.start, {.still = 1e-10}).places;
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (int axis = 0; axis < 2; ++axis) {
        places[i][axis] +=
            noise_mm * gaussian(seed, std::int64_t(states.size()), std::int64_t(i), axis);
      }
    }
    states.push_back({pull, stretch, places});
  }
  return states;
}

TEST(KnitStiffness, IsFoundInExactCrossings) {
  for (const double ratio : {4.0, 12.0}) {
    const auto states = seen(KnitPull::wale, KnitClamp::three_points, ratio, 0.0, 1);
    const auto found = knit_stiffness(patch(), {0, 1}, KnitClamp::three_points, states);
    // The motion ends within 1e-7 of the rest, the fit where its cost falls by less than 1e-9.
    EXPECT_NEAR(found.ratio.value, ratio, 1e-4 * ratio);
    EXPECT_NEAR(found.continuity.value, 0.2, 1e-4);
    EXPECT_EQ(found.agreeing, found.starts);
  }
}

TEST(KnitStiffness, KnowsHowSureItIs) {
  const double noise = 0.04;
  double sum = 0.0;
  constexpr int seeds = 4;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto states = seen(KnitPull::wale, KnitClamp::three_points, 10.0, noise, Seed(seed));
    const auto found = knit_stiffness(patch(), {0, 1}, KnitClamp::three_points, states);
    EXPECT_NEAR(found.noise_mm, noise, 0.15 * noise);  // 376 numbers: 4 % each
    const double a = std::log(found.ratio.value / 10.0) / found.log_ratio_sigma;
    const double b = (found.continuity.value - 0.2) / found.continuity.sigma;
    sum += a * a + b * b;
    const auto least =
        stiffness_bounds(patch(), {0, 1}, KnitClamp::three_points, states, 10.0, noise);
    EXPECT_NEAR(found.log_ratio_sigma, least.log_ratio, 0.2 * least.log_ratio);
    EXPECT_NEAR(found.continuity.sigma, least.continuity, 0.2 * least.continuity);
  }
  EXPECT_LT(sum, 26.1);  // chi square of 8, exceeded once in a thousand
}

TEST(KnitStiffness, SaysWhichClampTellsWhat) {
  const auto bound = [](KnitPull pull, KnitClamp clamp) {
    return stiffness_bounds(patch(), {0, 1}, clamp, seen(pull, clamp, 10.0, 0.0, 1), 10.0, 0.04);
  };
  const auto wale = bound(KnitPull::wale, KnitClamp::uniform);
  EXPECT_LT(wale.log_ratio, 0.1);
  EXPECT_GT(wale.continuity, 10.0);
  EXPECT_EQ(wale.rank, 1);
  const auto course = bound(KnitPull::course, KnitClamp::uniform);
  EXPECT_GT(course.log_ratio, 10.0);
  EXPECT_LT(course.continuity, 0.05);
  EXPECT_EQ(course.rank, 1);
  const auto both = bound(KnitPull::wale, KnitClamp::three_points);
  EXPECT_LT(both.log_ratio, 0.02);
  EXPECT_LT(both.continuity, 0.05);
  EXPECT_EQ(both.rank, 2);
  const auto states = seen(KnitPull::wale, KnitClamp::uniform, 10.0, 0.04, 1);
  const auto found = knit_stiffness(patch(), {0, 1}, KnitClamp::uniform, states);
  EXPECT_GE(found.remarks.size(), 3u);
}

TEST(KnitStiffness, IsNoSurerOfExactCrossingsThanTheyTell) {
  // Uniform clamps pulled along the courses: every ratio makes the same even places.
  const auto states = seen(KnitPull::course, KnitClamp::uniform, 10.0, 0.0, 1);
  const auto found = knit_stiffness(patch(), {0, 1}, KnitClamp::uniform, states);
  EXPECT_GT(found.log_ratio_sigma, 0.3);
  EXPECT_NEAR(found.continuity.value, 0.2, 5.0 * found.continuity.sigma);
  const auto hardly = [](const std::string& remark) { return remark.find("ratio") != remark.npos; };
  EXPECT_TRUE(std::any_of(found.remarks.begin(), found.remarks.end(), hardly));
}

TEST(KnitStiffness, NoticesAStretchThatWasNotTheOneStated) {
  auto states = seen(KnitPull::wale, KnitClamp::three_points, 10.0, 0.02, 1);
  states[1].stretch = 1.6;
  const auto found = knit_stiffness(patch(), {0, 1}, KnitClamp::three_points, states);
  const auto of_clamps = [](const std::string& remark) {
    return remark.find("state 2") != remark.npos;
  };
  EXPECT_TRUE(std::any_of(found.remarks.begin(), found.remarks.end(), of_clamps));
}

TEST(KnitStiffness, TakesALoadForTheStiffnessItself) {
  // Uniform along the wales, 10 columns: 5 of nylon and 4 of support in series share 4.5 * 1.5 mm.
  const auto states = seen(KnitPull::wale, KnitClamp::uniform, 10.0, 0.0, 1);
  const double tension = 6.75 / 5.4;
  const auto found = knit_stiffness(patch(), {0, 1}, KnitClamp::uniform, states,
                                    {.load_N = 10.0 * tension * 0.05});
  ASSERT_TRUE(found.nylon_N_per_mm);
  EXPECT_NEAR(found.nylon_N_per_mm->value, 0.05, 1e-5);
}

TEST(KnitStiffness, FindsLengthsAtRestThatAreNotKnown) {
  KnitNet guessed = patch();
  guessed.wale_length = 2.0, guessed.course_length = 1.5;
  const auto states = seen(KnitPull::wale, KnitClamp::three_points, 10.0, 0.02, 2);
  const auto found =
      knit_stiffness(guessed, {0, 1}, KnitClamp::three_points, states, {.lengths_known = false});
  EXPECT_NEAR(found.wale_mm.value, 2.0, 5.0 * found.wale_mm.sigma);
  EXPECT_NEAR(found.course_mm.value, 1.5, 5.0 * found.course_mm.sigma);
  EXPECT_LT(found.wale_mm.sigma, 0.01);
}

TEST(KnitStiffness, IsFoundWhereverThePictureWasTakenFrom) {
  auto states = seen(KnitPull::wale, KnitClamp::three_points, 10.0, 0.02, 3);
  for (std::size_t s = 0; s < states.size(); ++s) {
    for (auto& p : states[s].places) {
      const double turn = 0.05 * (1.0 - 3.0 * double(s)), scale = 1.03;
      p = scale * Eigen::Vector3d(std::cos(turn) * p.x() - std::sin(turn) * p.y() + 4.0,
                                  std::sin(turn) * p.x() + std::cos(turn) * p.y() - 7.0, 0.0);
    }
    states[s].places[33].setConstant(NAN);  // one was hidden
  }
  const auto found =
      knit_stiffness(patch(), {0, 1}, KnitClamp::three_points, states, {.frame_known = false});
  EXPECT_NEAR(std::log(found.ratio.value / 10.0), 0.0, 4.0 * found.log_ratio_sigma);
  EXPECT_NEAR(found.continuity.value, 0.2, 4.0 * found.continuity.sigma);
  EXPECT_NEAR(found.noise_mm, 1.03 * 0.02, 0.15 * 0.02);
  EXPECT_LT(found.log_ratio_sigma, 0.02);  // as with known frames: those that are held tell them
}

TEST(KnitStiffness, FollowsTheRestThatWasSeenWhereThereAreSeveral) {
  KnitNet net = patch();
  net.courses = net.wales = 20;
  net.stiffness = stiffness_of_courses(20, 16.0);
  const auto knit = pulled(net, KnitPull::wale, KnitClamp::three_points, 1.5);
  Places places = knit_motion(knit.net, knit.start, {.still = 1e-9}).places;
  const Places even = knit_at_rest(knit.net, knit.start).places;
  double apart = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    apart = std::max(apart, (places[i] - even[i]).norm());
    for (int axis = 0; axis < 2; ++axis) places[i][axis] += 0.02 * gaussian(8, int(i), axis);
  }
  ASSERT_GT(apart, 0.2);  // motion and Newton's method end in different rests
  const auto found = knit_stiffness(net, {0, 1}, KnitClamp::three_points,
                                    {{KnitPull::wale, 1.5, places}}, {.frame_known = false});
  EXPECT_NEAR(found.noise_mm, 0.02, 0.002);  // of 800 numbers: known to 2.5 %
  EXPECT_NEAR(std::log(found.ratio.value / 16.0), 0.0, 4.0 * found.log_ratio_sigma);
  EXPECT_NEAR(found.continuity.value, 0.2, 4.0 * found.continuity.sigma);
}

TEST(KnitStiffness, RefusesWhatHoldsNoAnswer) {
  const auto states = seen(KnitPull::wale, KnitClamp::uniform, 10.0, 0.0, 1);
  EXPECT_THROW(knit_stiffness(patch(), {0, 1}, KnitClamp::uniform, {}), Error);
  EXPECT_THROW(knit_stiffness(patch(), {0}, KnitClamp::uniform, states), Error);
  auto pushed = states;
  pushed[0].stretch = 0.5;
  EXPECT_THROW(knit_stiffness(patch(), {0, 1}, KnitClamp::uniform, pushed), Error);
  auto far_out = states;
  far_out[0].places[44] = {1e200, 0.0, 0.0};
  EXPECT_THROW(knit_stiffness(patch(), {0, 1}, KnitClamp::uniform, far_out), Error);
  auto short_one = states;
  short_one[0].places.pop_back();
  EXPECT_THROW(knit_stiffness(patch(), {0, 1}, KnitClamp::uniform, short_one), Error);
}

}  // namespace
}  // namespace hada
