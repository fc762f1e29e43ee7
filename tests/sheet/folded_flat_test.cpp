#include "sheet/folded_flat.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/sheet/fold_steps.h"

namespace hada {
namespace {

FoldState replay(std::vector<FoldStep> steps) {
  FoldLog log;
  log.steps = std::move(steps);
  return replayed(log).back();
}

FoldStep drawn(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return line(FoldAction::fold, from, to);
}

TEST(Flatten, LeavesTheFaceThatStaysWhereItIs) {
  for (const int staying : {0, 1}) {
    FoldState state = with_lines_drawn(replay({drawn({0.5, 0.0}, {0.5, 1.0})}), "half");
    const auto before = state.sheet.folded;
    flatten(state, "half", staying);
    for (const int v : state.sheet.corners_of(staying)) {
      EXPECT_LT((state.sheet.folded[std::size_t(v)] - before[std::size_t(v)]).norm(), 1e-12);
    }
    EXPECT_TRUE(state.flat);
    ASSERT_EQ(state.order.size(), 1u);
    EXPECT_EQ(order_flaw(state), "");
  }
}

TEST(Flatten, SaysWherePaperWouldTear) {
  // Three folds from the middle: no vertex of odd degree folds flat.
  FoldState state =
      with_lines_drawn(replay({drawn({0.5, 0.5}, {0.5, 0.0}), drawn({0.5, 0.5}, {1.0, 1.0}),
                               drawn({0.5, 0.5}, {0.0, 1.0})}),
                       "odd");
  EXPECT_THROW(flatten(state, "odd"), Error);
}

TEST(OrderFlaw, NamesFacesThatLieOnEachOtherWithoutOne) {
  FoldState state = replay({through({0.5, -1}, {0.5, 2})});
  EXPECT_EQ(order_flaw(state), "");
  state.order.clear();
  EXPECT_NE(order_flaw(state), "");
}

TEST(SettleMoved, KnowsWhatCameToLieOnWhat) {
  FoldState state = replay({line(FoldAction::crease, {0.5, 0.0}, {0.5, 1.0}),
                            line(FoldAction::swing, {0.9, 0.5}, {0.5, 0.5}, 90.0)});
  EXPECT_FALSE(state.flat);
  EXPECT_TRUE(state.order.empty());
  // The right half, upright now, is laid on the left one.
  const auto before = state.sheet.folded;
  for (auto& p : state.sheet.folded) {
    if (p.z() > 0.1) p = {0.5 - p.z(), p.y(), 0.0};
  }
  for (double& angle : state.sheet.fold_angles) angle *= 2.0;
  settle_moved(state, before);
  EXPECT_TRUE(state.flat);
  EXPECT_EQ(state.order.size(), 1u);
  EXPECT_EQ(order_flaw(state), "");
}

}  // namespace
}  // namespace hada
