#include "sheet/held_swing.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace hada {
namespace {

// A square with a crease through its middle, folded by 30 degrees.
FoldState half_open() {
  const FoldLog log{
      "book",
      1.0,
      {{.action = FoldAction::crease, .from = {0.5, 0.0}, .to = {0.5, 1.0}},
       {.action = FoldAction::swing, .from = {0.9, 0.5}, .to = {0.5, 0.5}, .degrees = 30.0}}};
  return replayed(log).back();
}

const FoldStep swing{.action = FoldAction::swing, .from = {0.9, 0.5}, .to = {0.5, 0.5}};

TEST(HeldSwing, ManySmallTurnsLeadWhereOneStepDoes) {
  HeldSwing held(half_open(), swing, true, "book");
  for (int move = 0; move < 100; ++move) held.further(move % 3 == 2 ? -1.0 : 2.0);
  EXPECT_NEAR(held.degrees(), 101.0, 1e-9);
  FoldStep step = swing;
  step.degrees = held.degrees();
  const FoldState once = folded_on(half_open(), step, "book");
  for (std::size_t v = 0; v < once.sheet.folded.size(); ++v) {
    EXPECT_LT((held.state().sheet.folded[v] - once.sheet.folded[v]).norm(), 1e-12);
  }
  EXPECT_EQ(held.state().flat, once.flat);
}

TEST(HeldSwing, StopsWhereFacesMeetAndComesBack) {
  HeldSwing held(half_open(), swing, true, "book");
  held.further(140.0);
  EXPECT_FALSE(held.state().contact);
  held.further(30.0);
  ASSERT_TRUE(held.state().contact);
  EXPECT_NEAR(held.degrees(), 150.0, 0.1);
  EXPECT_NEAR(held.state().contact->degrees, 10.0, 0.1);
  held.further(-100.0);
  EXPECT_FALSE(held.state().contact);
  EXPECT_NEAR(held.degrees(), 50.0, 0.1);
}

TEST(HeldSwing, RefusesAPlaceOffThePaper) {
  FoldStep off = swing;
  off.from = {1.5, 0.5};
  EXPECT_THROW(HeldSwing(half_open(), off, false, "book"), Error);
}

}  // namespace
}  // namespace hada
