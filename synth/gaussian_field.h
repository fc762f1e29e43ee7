#pragma once

#include <functional>
#include <vector>

#include "core/extent.h"
#include "core/grid.h"
#include "core/random.h"

namespace hada {

/// Fills `density` with the power spectral density at every (fx[k], fy).
using PsdOfRow = std::function<void(const std::vector<double>& fx, double fy, float* density)>;

/// A realisation of the zero-mean Gaussian field whose power spectral density `psd` gives by rows.
Grid<float> gaussian_field_by_rows(const PsdOfRow& psd, const Extent& extent, Seed seed);

/// A realisation of the zero-mean Gaussian field with power spectral density `psd(fx, fy)`.
///
/// psd      in unit^2 per (cycle / unit)^2, even in (fx, fy), called from several threads at the
///          frequencies of the grid, j / width and -i / height; the mean (0, 0) and the Nyquist
///          row and column, which a grid knows by half only, are left out
/// returns  `extent.rows` x `extent.cols` values that tile; the coefficient at each integer
///          frequency (i, j) depends on seed, i and j alone, so that another pitch samples the
///          same field
template <class Psd>
Grid<float> gaussian_field(const Psd& psd, const Extent& extent, Seed seed) {
  return gaussian_field_by_rows(
      [&](const std::vector<double>& fx, double fy, float* density) {
        for (std::size_t k = 0; k < fx.size(); ++k) density[k] = float(psd(fx[k], fy));
      },
      extent, seed);
}

}  // namespace hada
