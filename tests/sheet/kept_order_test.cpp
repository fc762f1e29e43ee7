#include "sheet/kept_order.h"

#include <numbers>

#include <gtest/gtest.h>

#include "sheet/fold_log.h"
#include "sheet/folded_flat.h"
#include "tests/sheet/fold_steps.h"

namespace hada {
namespace {

using Eigen::Vector2d;

TEST(KeptOrder, OfTurnedFlapsIsThatOfPaper) {
  // The left third over, then the right one over it: three layers, each turn lands on top.
  FoldLog log;
  log.steps = {line(FoldAction::turn, {1.0 / 3, -1}, {1.0 / 3, 2}),
               line(FoldAction::turn, {2.0 / 3, 2}, {2.0 / 3, -1})};
  const FoldState state = replayed(log).back();
  EXPECT_TRUE(state.flat);
  ASSERT_EQ(state.order.size(), 3u);  // every pair of three
  EXPECT_EQ(order_flaw(state), "");
  for (int e = 0; e < state.sheet.edges(); ++e) {
    if (state.sheet.is_border(e)) continue;
    EXPECT_EQ(state.sheet.creases[std::size_t(e)], Crease::valley);
    EXPECT_EQ(state.sheet.fold_angles[std::size_t(e)], std::numbers::pi);
  }
  // The other way about paper would have to pass: the flaw is seen.
  FoldState wrong = state;
  for (FaceOrder& o : wrong.order) o.order = -o.order;
  EXPECT_NE(order_flaw(wrong), "");
  wrong = state;
  wrong.order.pop_back();
  EXPECT_NE(order_flaw(wrong), "");
}

TEST(KeptOrder, IsInheritedByThePartsOfACutFace) {
  FoldLog log;
  log.steps = {line(FoldAction::turn, {0.5, -1}, {0.5, 2}),
               line(FoldAction::turn, {-1, 0.5}, {2, 0.5}, 40.0)};
  const auto states = replayed(log);
  ASSERT_EQ(states[1].order.size(), 1u);
  // Two layers cut across: each half of the one lies on the half of the other beside it, also
  // where both stand in space.
  ASSERT_EQ(states[2].order.size(), 2u);
  for (const FaceOrder& o : states[2].order) EXPECT_EQ(o.order, states[1].order[0].order);
}

TEST(KeptOrder, IsForgottenOfFacesThatParted) {
  FoldLog log;
  log.steps = {line(FoldAction::turn, {0.5, -1}, {0.5, 2}),
               line(FoldAction::turn, {0.75, 2}, {0.75, -1}, 70.0)};
  log.steps[1].layers = 1;
  const auto states = replayed(log);
  EXPECT_EQ(states[1].order.size(), 1u);
  EXPECT_EQ(states[2].order.size(), 1u);  // beyond the line the layers are apart
  log.steps[1].layers = 0;
  EXPECT_EQ(replayed(log).back().order.size(), 2u);
}

}  // namespace
}  // namespace hada
