#pragma once

#include <array>

#include "core/extent.h"
#include "core/grid.h"
#include "core/random.h"
#include "synth/wrinkle.h"

namespace hada {

/// A window of a sheet without end: the height at each pixel is a function of seed and place alone.
///
/// Each noise function is the sum of its kernels around the nodes of a lattice along its axes, 1.5
/// standard deviations apart, each node with a normal number of its own: white noise so sampled
/// differs from the whole by 2e-8 of the power. One that comes back is heard again period after
/// period, fainter each time (`EchoLattice`). The floor is white from
/// pixel to pixel: places that fall into one cell of a lattice of the window's pitch share its
/// number.
///
/// middle   of the window on the sheet, in the unit of the extent
/// returns  heights with the power spectral density of `wrinkle` (a little changed by ridges: what
///          gives it back in a tile is not local, and left out here); windows of one pitch that lie
///          a whole number of pixels apart agree where they overlap. They do not tile, and their
///          mean is not taken off.
/// throws   Error if noise that comes back, and is finer than a pixel, comes back twice one way or
///          is heard very often, would take minutes or much memory
Grid<float> endless_field(const Wrinkle<>& wrinkle, const Extent& window,
                          const std::array<double, 2>& middle, Seed seed);

}  // namespace hada
