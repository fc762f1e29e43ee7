#include "sheet/stack.h"

#include <gtest/gtest.h>

#include "sheet/fold_log.h"

namespace hada {
namespace {

using Eigen::Vector3d;

FoldState strip() {
  // Thirds of a square folded over each other: three layers above [0, 1/3].
  FoldLog log;
  log.title = "strip";
  for (const double x : {2.0 / 3.0, 1.0 / 3.0}) {
    FoldStep step;
    step.action = FoldAction::through;
    step.from = {x, 2.0};
    step.to = {x, -1.0};
    log.steps.push_back(step);
  }
  return replayed(log).back();
}

TEST(Stack, PilesLayersAndSeesTheOneOnTop) {
  const FoldState state = strip();
  const Stack stack = stack_of(state.sheet, state.order);
  std::vector<int> levels = stack.level;
  std::sort(levels.begin(), levels.end());
  EXPECT_EQ(levels, (std::vector<int>{0, 1, 2}));
  for (const Vector3d& up : stack.up) EXPECT_NEAR(up.z(), 1.0, 1e-12);
  const double x = state.sheet.folded[0].x() < 0.5 ? 0.5 / 3.0 : 2.5 / 3.0;
  for (const double way : {-1.0, 1.0}) {
    const auto found = seen(state.sheet, stack, {{x, 0.5, -3.0 * way}, {0.0, 0.0, way}});
    ASSERT_TRUE(found);
    EXPECT_EQ(stack.level[std::size_t(found->face)], way < 0.0 ? 2 : 0);
  }
}

TEST(Stack, LetsGoOfAFaceThatIsTurnedAway) {
  FoldState state = strip();
  const Stack before = stack_of(state.sheet, state.order);
  Sheet& sheet = state.sheet;
  for (std::size_t v = 0; v < sheet.flat.size(); ++v) sheet.folded[v].z() = 0.1 * sheet.flat[v].x();
  const Stack after = stack_of(state.sheet, state.order);
  EXPECT_EQ(after.level, std::vector<int>(3, 0));
  EXPECT_NE(before.level, after.level);
}

}  // namespace
}  // namespace hada
