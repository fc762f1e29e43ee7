#include <cmath>

#include "bench/integration_peers.h"
#include "bench/integration_study.h"
#include "core/parallel.h"
#include "core/random.h"
#include "reconstruct/integrate.h"

namespace hada {

SolverRun run_weighted(const IntegrationScene& scene, WeightKind kind) {
  const int size = scene.mask.rows();
  Grid<float> weight(size, size);
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col) {
      const double x = double(col) / size;
      const double y = double(row) / size;
      const double exponent =
          kind == WeightKind::equal    ? 0.0
          : kind == WeightKind::smooth ? 3.0 * std::sin(10.0 * y - 6.0 * x) - 3.0
          : kind == WeightKind::disc   ? (std::hypot(x - 0.3, y - 0.6) < 0.2 ? -6.0 : 0.0)
                                       : -6.0 * uniform(8, row, col);
      weight(row, col) = float(std::pow(10.0, exponent));
    }
  }
  SlopeSolver solver(scene.mask, edge_weights(weight));
  const IntegrateOptions options;
  const Grid<float> height = solver.height(scene.slopes, options.tolerance_px, options.max_cycles);
  SolverRun run{"hada, with weights", size};
  run.error_px = error_px(scene, height);
  run.cycles = solver.cycles();
  return run;
}

bool same_at_two_threads(const IntegrationScene& scene) {
  const IntegrateOptions options;
  const auto height = [&](int threads) {
    set_threads(threads);
    return SlopeSolver(scene.mask).height(scene.slopes, options.tolerance_px, options.max_cycles);
  };
  const bool same = height(1) == height(2);
  set_threads(0);
  return same;
}

}  // namespace hada
