#pragma once

#include <string>
#include <vector>

#include "sheet/sheet.h"

namespace hada {

/// Where a sheet lies when all its folds are folded flat.
struct FlatState {
  std::vector<Eigen::Vector2d> vertices;
  std::vector<bool> turned;  // of the faces: the printed side is down
  double gap = 0.0;          // the furthest that two faces disagree about a vertex
};

/// Folds every mountain, valley and unassigned crease by half a turn. The first face stays.
///
/// Faces are reached from the first along a shortest chain of neighbours, which keeps rounding
/// small; a vertex lies where the first of its faces puts it.
FlatState flat_state(const Sheet& sheet);

}  // namespace hada
