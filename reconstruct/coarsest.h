#pragma once

#include <optional>
#include <vector>

#include "reconstruct/graph_factors.h"
#include "reconstruct/pixel_level.h"

namespace hada {

/// The exact solution on the coarsest level, by a sparse factorisation in double precision.
///
/// Sweeps would do on a few cells side by side. But the parts of a torn mask can hang together as
/// one long path, however few they are.
class CoarsestSolver {
 public:
  /// How many nodes have edges; the others stay at 0.
  static std::size_t size_of(const PixelLevel& level);

  explicit CoarsestSolver(const PixelLevel& level);

  /// Sets level.value from level.right, with zero mean over the nodes of each region.
  void solve(PixelLevel& level);

 private:
  std::vector<PixelLevel::Node> nodes_;
  std::optional<GraphFactors> factors_;
  Eigen::VectorXd values_;
};

}  // namespace hada
