#include "mechanics/drawn_over.h"

#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"
#include "synth/leg.h"

namespace hada {
namespace {

TEST(DrawnOver, LaysEvenRingsAroundTheLeg) {
  const LegShape shape;
  const Body leg(leg_mesh(shape));
  const WearOptions options{.courses = 15, .wales = 64};
  const auto span = tube_span(leg, options);
  EXPECT_NEAR(span.from, 35.0, 1e-9);
  EXPECT_NEAR(span.to, 665.0, 1e-9);
  const auto places = drawn_over(leg, options, span);
  for (int i = 0; i < 15 * 64; ++i) {
    // A ray is lost by a share of 1e-9 on the side of a triangle of some mm.
    EXPECT_NEAR(places[std::size_t(i)].place.y(), 35.0 + 45.0 * (i / 64), 1e-6);
  }
  // The ankle is the thinnest place; its girth grows a little over the lowest twentieth.
  EXPECT_GT(smallest_girth(places, options), shape.ankle_mm);
  EXPECT_LT(smallest_girth(places, options), 1.1 * shape.ankle_mm);
}

TEST(DrawnOver, KnowsEachEndByItself) {
  const Body leg(leg_mesh());
  const auto above = tube_span(leg, {.from_mm = 100.0}), below = tube_span(leg, {.to_mm = 500.0});
  EXPECT_EQ(above.from, 100.0);
  EXPECT_NEAR(above.to, 665.0, 1e-9);
  EXPECT_NEAR(below.from, 35.0, 1e-9);
  EXPECT_EQ(below.to, 500.0);
}

TEST(DrawnOver, RefusesHeightsThatTheBodyDoesNotHave) {
  const Body leg(leg_mesh());
  EXPECT_THROW(tube_span(leg, {.from_mm = -5.0, .to_mm = 100.0}), Error);
  EXPECT_THROW(tube_span(leg, {.from_mm = 100.0, .to_mm = 50.0}), Error);
  EXPECT_THROW(tube_span(leg, {.from_mm = 0.0, .to_mm = NAN}), Error);
}

}  // namespace
}  // namespace hada
