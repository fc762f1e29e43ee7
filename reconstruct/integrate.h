#pragma once

#include <optional>

#include "core/grid.h"
#include "core/surface.h"
#include "reconstruct/slopes.h"

namespace hada {

struct IntegrateOptions {
  double relative_tolerance = 1e-8;  // of the height in the energy norm, where the solver stops
  int max_iterations = 500;
  std::optional<PinHole> pin_hole{};  // absent: seen from straight above, at every pixel
};

/// The height whose differences agree best with the slopes of `normals`, zero-mean.
///
/// Minimises the sum over neighbouring pixels of the mask of (z_right - z - pitch p)^2 and
/// (z_down - z + pitch q)^2, with p = -nx/nz, q = -ny/nz the mean of the two pixels (trapezoidal,
/// so exact for a quadratic surface); separate regions of the mask are levelled each on its own.
///
/// With a pin-hole the same is done for w = -D log(1 - z / D) (see `slopes_of`), and the height is
/// z of the point that each pixel sees, on the lattice of the picture; w has zero mean then.
///
/// normals  unit length, z > 0; pixels outside `mask` are not read
/// pitch    distance between neighbouring pixels, > 0; the height is in its unit
/// returns  a grid of the same size; 0 outside the mask
/// throws   Error if the mask is empty
///
/// Conjugate gradients on the normal equations, preconditioned by one multigrid V-cycle.
/// Source: Horn and Brooks, CVGIP 33 (1986); Kiso et al., section 4.
Grid<float> integrate(const NormalMap& normals, const Mask& mask, double pitch,
                      const IntegrateOptions& options = {});

/// The same height by plain conjugate gradients on the stored matrix A^T A, as the paper does it.
///
/// Slow; the reference that `integrate` is tested against.
Grid<double> integrate_reference(const NormalMap& normals, const Mask& mask, double pitch,
                                 double relative_tolerance = 1e-12);

}  // namespace hada
