#pragma once

#include <string>
#include <vector>

#include "core/surface.h"
#include "reconstruct/slope_solver.h"

namespace hada {

/// A mask and slopes whose exact least-squares height is known, whatever the mask: every mean of
/// two slopes is the step of the height between them.
struct IntegrationScene {
  Mask mask;
  SlopeMap slopes;
  Grid<double> height;
};

enum class MaskKind { full, irregular, slits };

/// full: a square. irregular: a lobed outline, 60 holes, single pixels missing, about 80 % are
/// left. slits: walls 2 px wide, open at the top and the bottom in turn.
IntegrationScene integration_scene(MaskKind kind, int size);

/// How a solver did.
struct SolverRun {
  std::string solver;
  int size = 0;
  double seconds = 0.0;   // of the processor, one thread; setup and solution, median of the repeats
  double error_px = 0.0;  // root mean square, against the known height
  double megabytes = 0.0;  // that the process held more than before, at most; 0: not asked
  int cycles = 0;
};

SolverRun run_ours(const IntegrationScene& scene, int repeats);
SolverRun run_eigen_cg(const IntegrationScene& scene);
/// Empty where the library was not there when this was built.
std::vector<SolverRun> run_peers(const IntegrationScene& scene);

/// Seconds that reading an array of size x size floats once takes, the best of 20.
double one_pass_seconds(int size);

}  // namespace hada
