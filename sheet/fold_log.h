#pragma once

#include <optional>
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
  through,  // folds all layers that the line crosses, seen from above, or those of `faces` alone:
            // what lies to its left moves
  turn,     // turns what lies to the left of the line by `degrees` about it, all layers together,
            // or the flap on top or at the bottom alone
  squash,   // presses the sheet towards the ground to `share` of its height, then lets it relax
  over,     // turns the whole sheet over, about the upright line through `from`
  score,    // a crease on the sheet as it lies, seen along a stroke; not folded yet
  swing,    // turns the face that is held at `from` by `degrees` about its crease at `to`, both
            // places on the flat sheet; what hangs on it follows
};

/// A line drawn on the sheet as it is seen: from where, and two places on the lines of sight.
struct FoldStroke {
  Eigen::Vector3d eye{0.0, 0.0, 0.0};
  Eigen::Vector3d from{0.0, 0.0, 0.0};
  Eigen::Vector3d to{0.0, 0.0, 0.0};
};

/// One step of a log. Lines are on the flat sheet, or seen from above on the folded one.
struct FoldStep {
  FoldAction action = FoldAction::crease;
  Eigen::Vector2d from{0.0, 0.0};
  Eigen::Vector2d to{0.0, 0.0};
  Crease crease = Crease::unassigned;  // of `fold`
  double degrees = 180.0;              // of `turn` and `swing`, towards the viewer > 0
  int layers = 0;                      // that `turn` takes: 0 all, 1 the top flap, -1 the bottom
  bool stiff = false;                  // of `through`: what moves turns as one, no fold in it turns
                                       // inside out
  std::vector<Eigen::Vector2d> mountains =
      {};                                     // places on the flat sheet: the nearest of the folds
  std::vector<Eigen::Vector2d> valleys = {};  // that `through` leaves open go this way
  double share = 0.1;                         // of `squash`
  FoldStroke stroke = {};                     // of `score`
  std::vector<Eigen::Vector2d> faces =
      {};  // places on the flat sheet: `score` and `through`
           // crease these faces alone, with `swing` the flaps that hold them turn
           // too; of `swing` none: all that lie on each other
  std::vector<Eigen::Vector2d> pins = {};  // places of faces that `swing` leaves where they are
  std::string note = {};                   // what a person would say of it
};

/// A square sheet and all that was done to it. Undo is a replay without the last step.
struct FoldLog {
  std::string title;
  double side = 1.0;
  std::vector<FoldStep> steps;
};

/// A line on the flat sheet that waits for the others: alone it may end inside a face.
struct DrawnLine {
  Eigen::Vector2d from, to;
  Crease crease;
};

/// Two faces that met before a step had gone all its way, and how far it went.
struct FoldContact {
  int face = 0;
  int other = 0;
  double degrees = 0.0;
};

/// The sheet after a step.
struct FoldState {
  Sheet sheet;                              // `folded` is where it lies
  std::vector<FaceOrder> order;             // of all faces that lie on each other
  bool flat = true;                         // all folds are open or shut, and all faces level
  std::optional<FoldContact> contact = {};  // of the step that led here
  std::vector<DrawnLine> waiting;  // drawn, and put on the sheet with the next step that moves it
};

/// The sheet with the lines put on it that wait for the others.
/// throws  Error with `where` if they leave no sheet
FoldState with_lines_drawn(FoldState state, const std::string& where);

/// The state that a step leads to.
///
/// throws  Error with `where` if its line crosses no paper, the paper would tear or block itself
FoldState folded_on(FoldState state, const FoldStep& step, const std::string& where);

/// The states after each step, the square sheet first.
///
/// Where a fold's direction is left open, the first order of layers that blocks nothing decides,
/// and later steps keep to it.
///
/// throws  Error naming the step if its line crosses no paper, the paper would tear or block itself
std::vector<FoldState> replayed(const FoldLog& log);

}  // namespace hada
