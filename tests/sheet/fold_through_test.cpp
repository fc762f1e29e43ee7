#include "sheet/fold_through.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "sheet/folded_flat.h"
#include "tests/sheet/fold_steps.h"

namespace hada {
namespace {

using Eigen::Vector2d;

FoldState half_folded() {
  FoldLog log;
  log.steps = {through({0.5, -1}, {0.5, 2})};  // the left half comes over the right one
  return replayed(log).back();
}

Crease letter_at(const Sheet& sheet, const Vector2d& place) {
  for (int e = 0; e < sheet.edges(); ++e) {
    const Vector2d a = sheet.flat[std::size_t(sheet.origin(2 * e))],
                   b = sheet.flat[std::size_t(sheet.target(2 * e))];
    if ((0.5 * (a + b) - place).norm() < 1e-9) return sheet.creases[std::size_t(e)];
  }
  return Crease::join;
}

TEST(FoldThrough, FoldsChosenLayersAlone) {
  const FoldState half = half_folded();
  FoldStep corner = through({1.0, 0.7}, {0.7, 1.0});
  // The corner at (1, 1) of the flat sheet lies on that at (0, 1).
  FoldState both = half, one = half;
  std::swap(corner.from, corner.to);
  fold_through(both, corner, "both");
  EXPECT_EQ(both.sheet.faces(), 4);
  corner.faces = {{0.9, 0.5}};
  fold_through(one, corner, "one");
  EXPECT_EQ(one.sheet.faces(), 3);
  EXPECT_EQ(order_flaw(one), "");
  EXPECT_EQ(letter_at(one.sheet, {0.15, 0.85}), Crease::join);  // the other layer has no crease
  corner.faces = {{1.5, 0.5}};
  EXPECT_THROW(fold_through(one, corner, "beside"), Error);
}

TEST(FoldThrough, FoldsTheWayThatIsSaid) {
  for (const bool valley : {true, false}) {
    FoldState state = half_folded();
    FoldStep step = through({2, 0.5}, {-1, 0.5});
    step.stiff = true;
    (valley ? step.valleys : step.mountains) = {{0.75, 0.5}};
    fold_through(state, step, "quarter");
    EXPECT_EQ(letter_at(state.sheet, {0.75, 0.5}), valley ? Crease::valley : Crease::mountain);
    // Both layers turn as one: printed on opposite sides, they fold to opposite letters.
    EXPECT_EQ(letter_at(state.sheet, {0.25, 0.5}), valley ? Crease::mountain : Crease::valley);
    EXPECT_EQ(order_flaw(state), "");
  }
}

TEST(FoldThrough, KeepsTheOrderOfWhatStays) {
  FoldState state = half_folded();
  ASSERT_EQ(state.order.size(), 1u);
  const FaceOrder before = state.order[0];
  FoldStep step = through({0.9, 2}, {0.9, -1});
  step.stiff = true;
  fold_through(state, step, "edge");
  // Of both faces one part kept its number; they lie on each other as before.
  bool found = false;
  for (const FaceOrder& o : state.order) {
    if (o.face != before.face || o.other != before.other) continue;
    EXPECT_EQ(o.order, before.order);
    found = true;
  }
  EXPECT_TRUE(found);
}

TEST(FoldThrough, NeedsAFlatSheet) {
  FoldState state = half_folded();
  state.flat = false;
  EXPECT_THROW(fold_through(state, through({0.9, 2}, {0.9, -1}), "edge"), Error);
}

}  // namespace
}  // namespace hada
