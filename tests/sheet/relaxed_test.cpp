#include "sheet/relaxed.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "sheet/simulate.h"
#include "tests/sheet/patterns.h"

namespace hada {
namespace {

// A vertex of four folds, half folded, and its points moved at random.
Sheet shaken(double by) {
  Sheet sheet = sheet_of(vertex_fold({0, 90, 200, 270}, "VVVM"), "vertex");
  sheet.folded = simulate(sheet, {.share = 0.3}).places;
  for (std::size_t v = 0; v < sheet.folded.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) sheet.folded[v][axis] += by * gaussian(7, int(v), axis);
  }
  return sheet;
}

TEST(Stiffened, IsStiffByEverySolver) {
  const Sheet sheet = shaken(0.01);
  const StiffSheet exact = stiffened(sheet);
  EXPECT_LT(exact.strain, 1e-9);
  EXPECT_LT(exact.planarity, 1e-5);
  for (const StiffSolver solver : {StiffSolver::faithful, StiffSolver::massed}) {
    const StiffSheet springs = stiffened(sheet, {.solver = solver});
    EXPECT_LT(springs.strain, 1.01e-4);  // where springs count as settled
    EXPECT_GT(springs.steps, 0);
    EXPECT_LT(springs.steps, 20000);
    // Points as heavy as their springs never need their steps cut.
    if (solver == StiffSolver::massed) {
      EXPECT_EQ(springs.substeps, 1);
    }
  }
}

TEST(Stiffened, LeavesPinnedVertices) {
  const Sheet sheet = shaken(0.01);
  for (const StiffSolver solver :
       {StiffSolver::faithful, StiffSolver::massed, StiffSolver::exact}) {
    const StiffSheet pinned = stiffened(sheet, {.solver = solver, .pinned = {2}});
    EXPECT_EQ(pinned.places[2], sheet.folded[2]);
    EXPECT_NE(stiffened(sheet, {.solver = solver}).places[2], sheet.folded[2]);
    EXPECT_LT(pinned.strain, 1.01e-4);
  }
  EXPECT_THROW(stiffened(sheet, {.pinned = {99}}), Error);
}

}  // namespace
}  // namespace hada
