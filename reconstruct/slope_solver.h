#pragma once

#include <vector>

#include "core/surface.h"
#include "reconstruct/multigrid.h"
#include "reconstruct/regions.h"
#include "reconstruct/slopes.h"

namespace hada {

/// Least-squares heights over one mask, for as many slope maps as one likes.
///
/// The normal equations are never stored: the Laplacian of the pixel graph is applied cell by cell,
/// and conjugate gradients are preconditioned by one multigrid cycle.
class SlopeSolver {
 public:
  explicit SlopeSolver(const Mask& mask);

  /// The height in pixels, zero-mean in every connected region of the mask, 0 outside.
  ///
  /// relative_tolerance  of the error in the energy norm (as the preconditioner estimates it)
  Grid<float> height(const SlopeMap& slopes, double relative_tolerance, int max_iterations);

 private:
  void subtract_region_means(std::vector<double>& value) const;

  Multigrid multigrid_;
  Regions regions_;
};

}  // namespace hada
