#pragma once

#include <optional>

#include "core/surface.h"
#include "reconstruct/edges.h"
#include "reconstruct/multigrid.h"
#include "reconstruct/regions.h"
#include "reconstruct/slopes.h"
#include "reconstruct/weighted_solver.h"

namespace hada {

/// Least-squares heights over one mask, for as many slope maps as one likes.
///
/// The matrix of the normal equations is the Laplacian of the pixel graph. `Multigrid` solves it
/// cell by cell and never stores it; `WeightedSolver` does where edges have weights.
class SlopeSolver {
 public:
  /// With weights, every equation of two neighbours counts with its own, > 0.
  explicit SlopeSolver(const Mask& mask, std::optional<EdgeWeights> weights = {});

  /// The height in pixels, zero-mean in every connected region of the mask, 0 outside; it lies in
  /// the memory of the mask, as all arrays of the solver do.
  ///
  /// tolerance   root mean square error of the height in pixels, at which the solver stops
  /// max_cycles  of multigrid, where it stops otherwise
  /// done        is told of every cycle
  Grid<float> height(const SlopeMap& slopes, double tolerance, int max_cycles,
                     const CycleDone& done = {});
  /// The same for rises that are not means of slopes; with weights only.
  Grid<float> height(const EdgeRises& rises, double tolerance, int max_cycles,
                     const CycleDone& done = {});

  /// How many cycles the last height took.
  int cycles() const { return cycles_; }

 private:
  void set_right(const SlopeMap& slopes);
  float set_right(const SlopeMap& slopes, float step);
  void take_means_off(Grid<float>& height) const;
  Grid<float> levelled(const Grid<double>& value) const;

  const Mask& mask_;
  std::optional<Multigrid> multigrid_;
  std::optional<WeightedSolver> weighted_;
  Regions regions_;
  int cycles_ = 0;
};

}  // namespace hada
