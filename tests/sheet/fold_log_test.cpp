#include "sheet/fold_log.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "sheet/crossing.h"
#include "tests/sheet/fold_steps.h"

namespace hada {
namespace {

using Eigen::Vector2d;
using testing::HasSubstr;

FoldStep flat_fold(const Vector2d& from, const Vector2d& to) {
  FoldStep step;
  step.action = FoldAction::fold;
  step.from = from;
  step.to = to;
  return step;
}

FoldStep flatten() {
  FoldStep step;
  step.action = FoldAction::flatten;
  return step;
}

FoldStep turn(const Vector2d& from, const Vector2d& to, double degrees, int layers) {
  FoldStep step;
  step.action = FoldAction::turn;
  step.from = from;
  step.to = to;
  step.degrees = degrees;
  step.layers = layers;
  return step;
}

TEST(FoldLog, FoldsAllLayersThatTheLineCrosses) {
  // Halves of halves: a square of side 1/4 in 16 layers.
  FoldLog log;
  log.title = "quarters";
  log.steps = {through({0.5, 2}, {0.5, -1}), through({-1, 0.5}, {2, 0.5}),
               through({0.25, 2}, {0.25, -1}), through({-1, 0.25}, {2, 0.25})};
  const auto states = replayed(log);
  ASSERT_EQ(states.size(), 5u);
  EXPECT_EQ(states.back().sheet.faces(), 16);
  for (const auto& p : states.back().sheet.folded) {
    EXPECT_GT(p.x(), -1e-12);
    EXPECT_LT(p.x(), 0.25 + 1e-12);
    EXPECT_LT(p.y(), 0.25 + 1e-12);
  }
  EXPECT_EQ(states.back().order.size(), 120u);  // every pair of 16
}

TEST(FoldLog, OfAPreliminaryBaseNeedsAllItsFoldsAtOnce) {
  FoldLog log;
  log.title = "base";
  log.steps = {flat_fold({0, 0.5}, {1, 0.5}), flat_fold({0.5, 0}, {0.5, 1}),
               flat_fold({0.5, 0.5}, {1, 0}), flat_fold({0.5, 0.5}, {0, 1}), flatten()};
  const auto states = replayed(log);
  double low = 1e9, high = -1e9;
  for (const auto& p : states.back().sheet.folded) {
    low = std::min(low, p.head<2>().sum());
    high = std::max(high, p.head<2>().sum());
  }
  EXPECT_NEAR(high - low, 1.0, 1e-12);  // a square of side 1/2, seen along its diagonal
  log.steps.erase(log.steps.begin() + 3);
  EXPECT_THROW(replayed(log), Error);  // five folds around the middle
}

TEST(FoldLog, ReplaysToTheSameBitsAndUndoesByReplay) {
  FoldLog log;
  log.title = "strip";
  log.steps = {through({0.3, 2}, {0.3, -1}), through({-1, 0.4}, {2, 0.7}),
               turn({0.2, -1}, {0.2, 2}, 40.0, 0)};
  const auto once = replayed(log), twice = replayed(log);
  EXPECT_EQ(once.back().sheet.folded, twice.back().sheet.folded);
  EXPECT_EQ(once.back().order, twice.back().order);
  log.steps.pop_back();
  EXPECT_EQ(replayed(log).back().sheet.folded, once[2].sheet.folded);
}

TEST(FoldLog, TurnsTheFlapOnTopAlone) {
  FoldLog log;
  log.title = "flap";
  log.steps = {through({0.5, 2}, {0.5, -1}), turn({0.2, -1}, {0.2, 2}, 60.0, 1)};
  const Sheet sheet = replayed(log).back().sheet;
  int raised = 0, level = 0;
  for (const auto& p : sheet.folded) {
    raised += std::abs(p.z() - 0.2 * std::sin(std::numbers::pi / 3.0)) < 1e-12;
    level += p.x() < 1e-12 && p.z() == 0.0;
  }
  EXPECT_EQ(raised, 2);
  EXPECT_EQ(level, 2);
  EXPECT_TRUE(crossing_faces(sheet).empty());
}

TEST(FoldLog, NamesTheStepThatCannotBeDone) {
  FoldLog log;
  log.title = "bad";
  log.steps = {through({0.5, 2}, {0.5, -1}), through({5, 2}, {5, -1})};
  try {
    replayed(log);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("bad: step 2: its line crosses no paper"));
  }
}

TEST(CrossingFaces, AreSeen) {
  // The left third stands upright, the right one comes over and runs its end through it.
  FoldLog log;
  log.title = "cross";
  log.steps = {turn({0.25, -1}, {0.25, 2}, 90.0, 0), turn({0.75, 2}, {0.75, -1}, 150.0, 0)};
  Sheet sheet = replayed(log).back().sheet;
  EXPECT_TRUE(crossing_faces(sheet).empty());
  for (std::size_t v = 0; v < sheet.folded.size(); ++v) {
    if (sheet.flat[v].x() == 1.0) sheet.folded[v] << 0.0, sheet.flat[v].y() < 0.5 ? 0.3 : 0.7, 0.1;
  }
  EXPECT_EQ(crossing_faces(sheet).size(), 1u);
}

}  // namespace
}  // namespace hada
