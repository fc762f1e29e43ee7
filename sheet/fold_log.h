#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "sheet/flat_fold.h"
#include "sheet/sheet.h"

namespace hada {

/// What was done to the sheet.
enum class FoldAction {
  crease,   // a crease that is not folded yet, on the flat sheet from `from` to `to`
  fold,     // a fold on the flat sheet: as crease, but folded at the next `flatten`
  flatten,  // folds flat what is folded
  through,  // folds all layers that the line crosses, seen from above: what lies to its left moves
  turn,     // turns what lies to the left of the line by `degrees` about it, all layers together,
            // or the flap on top or at the bottom alone
  squash,   // presses the sheet towards the ground to `share` of its height, then lets it relax
  over,     // turns the whole sheet over, about the upright line through `from`
};

/// One step of a log. Lines are on the flat sheet, or seen from above on the folded one.
struct FoldStep {
  FoldAction action = FoldAction::crease;
  Eigen::Vector2d from{0.0, 0.0};
  Eigen::Vector2d to{0.0, 0.0};
  Crease crease = Crease::unassigned;  // of `fold`
  double degrees = 180.0;              // of `turn`, towards the viewer > 0
  int layers = 0;                      // that `turn` takes: 0 all, 1 the top flap, -1 the bottom
  double share = 0.1;                  // of `squash`
  std::string note;                    // what a person would say of it
};

/// A square sheet and all that was done to it. Undo is a replay without the last step.
struct FoldLog {
  std::string title;
  double side = 1.0;
  std::vector<FoldStep> steps;
};

/// The sheet after a step.
struct FoldState {
  Sheet sheet;                   // `folded` is where it lies
  std::vector<FaceOrder> order;  // of its layers
  bool flat = true;              // all folds are open or shut
};

/// The states after each step, the square sheet first.
///
/// Where a fold's direction is left open, the first order of layers that blocks nothing decides,
/// and later steps keep to it.
///
/// throws  Error naming the step if its line crosses no paper, the paper would tear or block itself
std::vector<FoldState> replayed(const FoldLog& log);

}  // namespace hada
