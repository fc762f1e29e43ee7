#include "sheet/turn_layers.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/error.h"
#include "sheet/places.h"
#include "tests/sheet/fold_steps.h"

namespace hada {
namespace {

// A square folded in half: the right half lies on the left one.
FoldState half_folded() {
  FoldLog log;
  log.steps = {through({0.5, 2}, {0.5, -1})};
  return replayed(log).back();
}

double height_of(const FoldState& state, const Eigen::Vector2d& flat) {
  return folded_place(state.sheet, face_at(state.sheet, flat), flat).z();
}

FoldStep upright(int layers) {
  FoldStep step = line(FoldAction::turn, {-1.0, 0.5}, {2.0, 0.5}, 90.0);
  step.layers = layers;
  return step;
}

TEST(TurnLayers, TurnsAllOfThemTogether) {
  FoldState state = half_folded();
  turn_layers(state, upright(0), "all");
  EXPECT_NEAR(height_of(state, {0.1, 1.0}), 0.5, 1e-12);
  EXPECT_NEAR(height_of(state, {0.9, 1.0}), 0.5, 1e-12);
  EXPECT_NEAR(height_of(state, {0.1, 0.1}), 0.0, 1e-12);
  EXPECT_EQ(state.sheet.faces(), 4);
  EXPECT_FALSE(state.flat);
}

TEST(TurnLayers, SaysThatALineMissesThePaper) {
  FoldState state = half_folded();
  FoldStep step = upright(0);
  step.from.y() = step.to.y() = 1.5;
  EXPECT_THROW(turn_layers(state, step, "beside"), Error);
}

TEST(TurnLayers, TakesAlongWhatTheFlapOnTopHangsOn) {
  // Both layers hang together along the fold.
  FoldState state = half_folded();
  turn_layers(state, upright(1), "top");
  EXPECT_NEAR(height_of(state, {0.1, 1.0}), 0.5, 1e-12);
  EXPECT_NEAR(height_of(state, {0.9, 1.0}), 0.5, 1e-12);
}

TEST(TurnLayers, TurnsTheOutermostFlapAlone) {
  // A crease across one quarter of a closed book: its corner on top, or that at the bottom.
  for (const int layers : {1, -1}) {
    FoldState state = half_folded();
    FoldStep corner = line(FoldAction::turn, {-0.2, 0.7}, {0.3, 1.2}, layers * 90.0);
    corner.layers = layers;
    turn_layers(state, corner, "corner");
    const double left = height_of(state, {0.0, 1.0}), right = height_of(state, {1.0, 1.0});
    EXPECT_NEAR(std::max(left * layers, right * layers), 0.1 * std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(std::min(left * layers, right * layers), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace hada
