#pragma once

#include <vector>

#include "reconstruct/noise.h"
#include "reconstruct/normal_plan.h"
#include "reconstruct/normals.h"

namespace hada {

/// Sums over pixels for each light; see `Judgement`.
struct LightSums {
  std::vector<double> picture, used, used_picture, left_out;

  void add(const LightSums& other);
};

/// The maps of all pixels before the noise is known.
struct NormalMaps {
  Orientation orientation;
  Residuals residuals;
  Grid<float> noise_gain;      // variance of the normal for a sample variance of 1
  Grid<float> light_variance;  // of the normal
  Grid<float> albedo_gain;     // variance of rho over its square, likewise

  NormalMaps(const LightStack& stack, bool uncertainty);
};

/// Solves the rows [begin, end) of a stack and fills them in: bands need nothing of each other, so
/// that a stack may pass through memory band by band.
///
/// `robust_pca` takes all pixels of a band together, the others each alone.
///
/// returns  one entry for each row, or for the whole band with `robust_pca`; empty without
/// uncertainty
std::vector<LightSums> solve_band(const TileSource& source, const NormalPlan& plan, int begin,
                                  int end, bool uncertainty, NormalMaps& maps);

}  // namespace hada
