#pragma once

#include <vector>

#include <Eigen/Core>

#include "sheet/sheet.h"

namespace hada {

/// How a sheet whose faces were bent or stretched becomes stiff again.
enum class StiffSolver {
  faithful,  // the paper's springs, all points of one mass
  massed,    // the same, a point as heavy as springs meet there: one step is one step
  exact,     // lengths and planes to rounding
};

struct StiffOptions {
  StiffSolver solver = StiffSolver::exact;
  std::vector<int> pinned = {};  // vertices that stay
  int most_steps = 20000;        // of the springs
  double strain = 1e-4;          // at which springs count as settled: bent faces settle slowly
};

struct StiffSheet {
  std::vector<Eigen::Vector3d> places;
  double strain = 0.0;     // largest change of a distance within a face, share of it
  double planarity = 0.0;  // largest distance of a corner from its face's plane, share of the sheet
  int steps = 0;
  int substeps = 1;  // that the springs' steps were cut into, to stay stable
};

/// The sheet from where it lies (`folded`), its faces as long and as flat as on the flat sheet.
///
/// throws  Error if a pinned vertex is none
StiffSheet stiffened(const Sheet& sheet, const StiffOptions& options = {});

}  // namespace hada
