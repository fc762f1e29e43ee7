#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/grid.h"
#include "core/surface.h"
#include "reconstruct/multigrid.h"
#include "reconstruct/slopes.h"

namespace hada {

struct IntegrateOptions {
  /// Root mean square error of the height, where the solver stops. Half of what is promised, 1e-4,
  /// because the error is an estimate.
  double tolerance_px = 5e-5;
  int max_cycles = 100;
  Grid<float> weight{};  // of a pixel, > 0: 1 over its variance; empty: all count alike
  CycleDone done{};      // is told of every cycle of the solver
  std::function<void(int rounds)> round_done{};  // and of every round of the search for jumps
  std::optional<PinHole> pin_hole{};             // absent: seen from straight above, at every pixel
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
/// returns  a grid of the same size; 0 outside the mask; all arrays lie in the memory of the mask
/// throws   Error if the mask is empty
///
/// Full multigrid (`Multigrid`); with weights, conjugate gradients around algebraic multigrid
/// (`WeightedSolver`), which keeps some ten bytes a pixel in memory wherever the mask lies.
/// Source: Horn and Brooks, CVGIP 33 (1986); Kiso et al., section 4.
Grid<float> integrate(const NormalMap& normals, const Mask& mask, double pitch,
                      const IntegrateOptions& options = {});

enum class Jumps { none, allowed, automatic };

/// A height, and whether it was allowed to jump.
struct Integrated {
  Grid<float> height;
  bool may_jump = false;
  std::string reason;  // a plain sentence
};

/// `integrate`, or the edge-aware height of `edge_aware.h` where the surface seems to hide parts of
/// itself.
///
/// Where jumps cut parts off all around, nothing says how high they lie over the rest: each lies
/// where the height without jumps has it in the mean (`place_parts`), and the reason says so.
///
/// automatic  allows jumps where the slopes do not agree with a height and most of their curl lies
///            in a few pixels, along lines
/// Maps that do not lie on the heap (see `Memory`) are taken for too large to find jumps in.
/// throws     Error as `integrate` does, or where weights are given, or maps too large, and jumps
///            are allowed
Integrated integrate_with_jumps(const NormalMap& normals, const Mask& mask, double pitch,
                                Jumps jumps, const IntegrateOptions& options = {});

/// The same height by plain conjugate gradients on the stored matrix A^T A, as the paper does it.
///
/// Slow; the reference that `integrate` is tested against.
Grid<double> integrate_reference(const NormalMap& normals, const Mask& mask, double pitch,
                                 double relative_tolerance = 1e-12);

}  // namespace hada
