#pragma once

#include <filesystem>
#include <memory_resource>
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
///
/// where  the maps lie; absent: on the heap
IntegrationScene integration_scene(MaskKind kind, int size,
                                   std::pmr::memory_resource* where = nullptr);

/// How a solver did.
struct SolverRun {
  std::string solver;
  int size = 0;
  double seconds = 0.0;    // of the processor on one thread, else on the wall; setup and solution,
                           // median of the repeats
  double error_px = 0.0;   // root mean square, against the known height
  double megabytes = 0.0;  // that the process held more than before, at most; 0: not asked
  int cycles = 0;
};

SolverRun run_ours(const IntegrationScene& scene, int repeats, int threads = 1);

/// Weights between 1e-6 and 1: equal ones, waves, a disc that hardly counts, pixel by pixel.
enum class WeightKind { equal, smooth, disc, random };

/// Cycles and error; the time is not taken.
SolverRun run_weighted(const IntegrationScene& scene, WeightKind kind);

/// The share of the pixels at which `height_sigma` is within 15 % of the spread of 200 heights,
/// each from normals with errors of their own, on an irregular mask; they are twice as large on the
/// right.
double share_of_good_sigmas(int size);

/// Whether the height has the same bytes on one and on two threads.
bool same_at_two_threads(const IntegrationScene& scene);

/// One height of a scene that lies in files in `folder`, by all threads: wall time, and the most
/// memory beside the files.
SolverRun run_on_disk(MaskKind kind, int size, const std::filesystem::path& folder);
SolverRun run_eigen_cg(const IntegrationScene& scene);
/// Empty where the library was not there when this was built.
std::vector<SolverRun> run_peers(const IntegrationScene& scene);

/// Seconds that reading an array of size x size floats once takes, the best of 20.
double one_pass_seconds(int size);

}  // namespace hada
