#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/light_stack.h"
#include "core/surface.h"
#include "reconstruct/level.h"
#include "reconstruct/normals.h"
#include "reconstruct/prior_heights.h"

namespace hada {

struct ReconstructOptions {
  Levelling levelling = Levelling::plane;
  Estimator estimator = default_estimator;
  std::optional<PriorHeights> prior{};  // on the pixels of the pictures: instead of levelling
  bool labels = false;                  // whether every sample gets its label
};

/// A surface, and what a person should know of how it came about.
struct Reconstruction {
  Surface surface;  // cropped to the bounding box of the mask; offset_px says where that lies
  Estimator estimator = default_estimator;  // that was used
  double noise = 0.0;                // of one grey sample, in units of the largest sample value
  double relighting_error = 0.0;     // root mean square, relative
  double left_out_error = 0.0;       // each sample against the fit to the others; all lit samples
  std::vector<double> light_errors;  // left_out_error of each light
  Grid<std::uint8_t> inliers;        // samples believed at each pixel of the surface
  Grid<float> albedo_sigma;          // of the grey albedo there
  std::vector<Grid<Sample>> labels;  // of each picture there; empty: not asked for
  double condition = 0.0;            // of the light directions
  std::vector<std::string> remarks;  // plain sentences: what is poor, and what would help
};

/// The surface that explains the pictures: normals, albedo, height and the sigma of each.
///
/// throws  Error if the mask is empty, or as `solve_normals` does
Reconstruction reconstruct(const LightStack& stack, const ReconstructOptions& options = {});

}  // namespace hada
