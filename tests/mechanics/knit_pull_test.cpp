#include "mechanics/knit_pull.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/error.h"

namespace hada {
namespace {

KnitNet small() {
  KnitNet net;
  net.courses = 4, net.wales = 7;
  net.course_length = 0.5;
  net.stiffness = stiffness_of_courses(4, 10.0);
  return net;
}

TEST(KnitPull, StretchesAlongTheYarnOrAcrossIt) {
  const auto along = pulled(small(), KnitPull::course, KnitClamp::uniform, 1.5);
  EXPECT_NEAR(along.start.back().x(), 1.5 * 3.0, 1e-15);
  EXPECT_NEAR(along.start.back().y(), 0.5 * 1.5, 1e-15);
  const auto up = pulled(small(), KnitPull::wale, KnitClamp::uniform, 1.5);
  EXPECT_NEAR(up.start.back().x(), 3.0, 1e-15);
  EXPECT_NEAR(up.start.back().y(), 1.5 * 0.5 * 1.5, 1e-15);
}

TEST(KnitPull, HoldsEdgesOrThreePointsOfThem) {
  const auto held = [](KnitPull pull, KnitClamp clamp) {
    const auto knit = pulled(small(), pull, clamp, 1.2);
    return std::count(knit.net.pinned.begin(), knit.net.pinned.end(), true);
  };
  EXPECT_EQ(held(KnitPull::wale, KnitClamp::uniform), 14);
  EXPECT_EQ(held(KnitPull::course, KnitClamp::uniform), 8);
  EXPECT_EQ(held(KnitPull::wale, KnitClamp::three_points), 6);
  EXPECT_EQ(held(KnitPull::course, KnitClamp::three_points), 6);
}

TEST(KnitPull, RefusesAStretchThatIsNone) {
  EXPECT_THROW(pulled(small(), KnitPull::wale, KnitClamp::uniform, 0.0), Error);
  EXPECT_THROW(pulled(small(), KnitPull::wale, KnitClamp::uniform, 0.99), Error);
  EXPECT_THROW(pulled(small(), KnitPull::wale, KnitClamp::uniform, NAN), Error);
}

}  // namespace
}  // namespace hada
