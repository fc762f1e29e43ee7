#include "studio/fold_session.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.h"

namespace hada {
namespace {

FoldStep half() {
  return {.action = FoldAction::through, .from = {0.5, 2.0}, .to = {0.5, -1.0}};
}

Ray down_to(double x, double y) {
  return {{x, y, 3.0}, {0.0, 0.0, -1.0}};
}

TEST(FoldSession, UndoesByGoingBackAndForgetsWhatWasUndone) {
  FoldSession session;
  EXPECT_TRUE(session.is_open());
  session.add(half());
  EXPECT_FALSE(session.is_open());
  session.go_to(0);
  EXPECT_TRUE(session.is_open());
  EXPECT_EQ(session.log().steps.size(), 1u);
  EXPECT_EQ(session.done().steps.size(), 0u);
  session.add({.action = FoldAction::over, .from = {0.5, 0.0}});
  EXPECT_EQ(session.log().steps.size(), 1u);
  session.go_to(99);
  EXPECT_EQ(session.at(), 1);
}

TEST(FoldSession, StaysAsItWasIfAStepCannotBeDone) {
  FoldSession session;
  FoldStep beside = half();
  beside.from.x() = beside.to.x() = 7.0;
  EXPECT_THROW(session.add(beside), Error);
  EXPECT_EQ(session.at(), 0);
  EXPECT_TRUE(session.log().steps.empty());
}

TEST(FoldSession, TogglesTheFaceThatIsSeenOrOneThatIsNamed) {
  FoldSession session;
  session.add(half());
  std::vector<Eigen::Vector2d> places;
  toggle(session, places, down_to(0.2, 0.5));
  ASSERT_EQ(places.size(), 1u);
  // One half is seen there and hides the other.
  const double seen = places[0].x(), hidden = 1.0 - seen;
  EXPECT_NEAR(std::abs(seen - 0.5), 0.3, 1e-12);
  toggle(session, places, Eigen::Vector2d(hidden, 0.3));
  EXPECT_EQ(places.size(), 2u);
  toggle(session, places, Eigen::Vector2d(seen, 0.9));  // the first, by another of its places
  ASSERT_EQ(places.size(), 1u);
  EXPECT_EQ(places[0].x(), hidden);
  EXPECT_THROW(toggle(session, places, Eigen::Vector2d(1.1, 0.5)), Error);
  EXPECT_THROW(toggle(session, places, down_to(0.9, 0.5)), Error);
}

TEST(FoldSession, DragsOnFromWhereTheHandWas) {
  FoldSession session;
  session.add(
      {.action = FoldAction::score, .stroke = {{0.5, 0.5, 3.0}, {0.5, 0.0, 0.0}, {0.5, 1.0, 0.0}}});
  session.grip = taken(session, down_to(0.9, 0.4), {});
  // The ray goes along the axis, and round it.
  const auto pointer = [](double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return Ray{{0.5 + std::cos(angle), -3.0, std::sin(angle)}, {0.0, 1.0, 0.0}};
  };
  for (const double degrees : {20.0, 55.0, 40.2}) drag(session, pointer(degrees), 1.0);
  ASSERT_TRUE(session.dragged);
  EXPECT_NEAR(session.grip->step.degrees, 40.0, 1e-9);
  const FoldState held = *session.dragged;
  session.add(FoldStep(session.grip->step));
  for (std::size_t v = 0; v < held.sheet.folded.size(); ++v) {
    EXPECT_LT((held.sheet.folded[v] - session.state().sheet.folded[v]).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace hada
