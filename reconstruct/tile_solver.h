#pragma once

#include <cstdint>
#include <vector>

#include "reconstruct/estimator.h"
#include "reconstruct/shared_terms.h"
#include "reconstruct/tile.h"

namespace hada {

/// What is common to all pixels of a stack before any of them is solved.
struct NormalPlan {
  Estimator estimator = default_estimator;
  std::vector<float> pseudo_inverse;  // of the distant lights: three rows
  NoiseLaw noise;
  SharedTerms terms;
  bool shared = false;  // whether `terms` are taken off
  // By how much bounced light from an albedo of 1/2 would turn the normals, rad, root mean square,
  // where the samples do not tell how strong it is; 0 where they do, and where it is not sought.
  double untold_bounce = 0.0;
};

/// Solves tiles, one after another, with room of its own: one for each thread.
class TileSolver {
 public:
  /// keep_weights  whether tile.weight, and what of tile.grey goes with it, is wanted
  TileSolver(const NormalPlan& plan, const Tile& like, bool keep_weights);

  /// Finds tile.x, y, z, and tile.weight if kept, as the estimator of the plan says; all but
  /// `robust_pca`, which looks at all pixels at once.
  ///
  /// all_trusted  whether every sample of the tile may count
  void solve(Tile& tile, bool all_trusted);

 private:
  void solve_robust(Tile& tile, bool all_trusted);
  void plain(Tile& tile, bool all_trusted);
  void gather(const Tile& tile, bool all_trusted);
  void scatter_to(Tile& tile) const;

  const NormalPlan& plan_;
  const bool keep_weights_;
  Tile doubtful_;  // the pixels that least squares does not explain, close together
  std::vector<std::uint8_t> flags_;
  std::vector<int> places_;  // of the doubtful pixels
  std::vector<int> still_;
};

/// How often the shared terms are taken off anew once the normals have moved.
inline constexpr int shared_rounds = 3;

}  // namespace hada
