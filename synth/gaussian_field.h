#pragma once

#include <functional>

#include "core/extent.h"
#include "core/grid.h"
#include "core/random.h"

namespace hada {

/// A realisation of the zero-mean Gaussian field with power spectral density `psd(fx, fy)`.
///
/// psd      in unit^2 per (cycle / unit)^2, even in (fx, fy), called from several threads at the
///          frequencies of the grid, j / width and -i / height; the mean (0, 0) and the Nyquist
///          row and column, which a grid knows by half only, are left out
/// returns  `extent.rows` x `extent.cols` values that tile; the coefficient at each integer
///          frequency (i, j) depends on seed, i and j alone, so that another pitch samples the
///          same field
Grid<float> gaussian_field(const std::function<double(double fx, double fy)>& psd,
                           const Extent& extent, Seed seed);

}  // namespace hada
