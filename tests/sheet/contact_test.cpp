#include "sheet/contact.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sheet/crossing.h"
#include "sheet/fold_log.h"

namespace hada {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

FoldStep turn(double x, double degrees, bool left, int layers = 0) {
  FoldStep step;
  step.action = FoldAction::turn;
  // What lies to the left of the line moves.
  step.from = {x, left ? -1.0 : 2.0};
  step.to = {x, left ? 2.0 : -1.0};
  step.degrees = degrees;
  step.layers = layers;
  return step;
}

TEST(Contact, StopsAFlapAtAWall) {
  FoldLog log;
  log.steps = {turn(0.25, 90.0, true), turn(0.6, 179.0, false)};
  const auto states = replayed(log);
  EXPECT_FALSE(states[1].contact);
  ASSERT_TRUE(states[2].contact);
  // The flap is 0.4 long and reaches the wall, 0.35 away, with its end. Tolerance: it goes in by
  // 1e-6 of the sheet before that counts, at less than 0.5 of the speed of its end.
  const double expected = std::acos(-0.35 / 0.4) / degree;
  EXPECT_NEAR(states[2].contact->degrees, expected, 1e-5 / 0.4 / degree);
  EXPECT_TRUE(crossing_faces(states[2].sheet, 2e-6).empty());
  // A shorter way passes below.
  log.steps[1].degrees = expected - 0.1;
  EXPECT_FALSE(replayed(log).back().contact);
}

TEST(Contact, LetsAFlapLandAndNotGoOn) {
  FoldLog log;
  log.steps = {turn(0.5, 200.0, false)};
  const FoldState state = replayed(log).back();
  ASSERT_TRUE(state.contact);
  EXPECT_NEAR(state.contact->degrees, 180.0, 1e-6);
  EXPECT_TRUE(state.flat);
  log.steps = {turn(0.5, 180.0, false)};
  EXPECT_FALSE(replayed(log).back().contact);
}

TEST(Contact, KeepsWhatLiesBelowBelow) {
  // Folded over at the middle, the left half lies on the right one. The lower layer cannot rise
  // through the upper, which can rise.
  FoldLog log;
  log.steps = {turn(0.5, 180.0, true)};
  const FoldState folded = replayed(log).back();
  ASSERT_EQ(folded.order.size(), 1u);
  for (const int layers : {1, -1}) {
    FoldState next = folded_on(folded, turn(0.75, 30.0, false, layers), "rise");
    EXPECT_EQ(next.contact.has_value(), layers < 0);
    EXPECT_NEAR(next.contact ? next.contact->degrees : 30.0, layers < 0 ? 0.0 : 30.0, 1e-6);
  }
  // Downwards it is the other way round.
  EXPECT_TRUE(folded_on(folded, turn(0.75, -30.0, false, 1), "sink").contact);
  EXPECT_FALSE(folded_on(folded, turn(0.75, -30.0, false, -1), "sink").contact);
}

TEST(ContactWatch, LetsLayersPartAndNotPass) {
  FoldLog log;
  log.steps = {turn(0.5, 180.0, true)};  // the left half comes over the right one
  const FoldState state = replayed(log).back();
  const ContactWatch watch(state.sheet, state.order, {}, 1e-6);
  auto apart = state.sheet.folded, through = apart;
  for (std::size_t v = 0; v < apart.size(); ++v) {
    const double lift = 0.02 * std::max(0.0, 0.5 - state.sheet.flat[v].x());
    apart[v].z() += lift;
    through[v].z() -= lift;
  }
  EXPECT_FALSE(watch.meets(apart));
  EXPECT_TRUE(watch.meets(through));
}

}  // namespace
}  // namespace hada
