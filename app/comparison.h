#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "app/measurement.h"
#include "core/light_stack.h"
#include "core/surface.h"

namespace hada {

/// How far two surfaces differ where they lie over each other.
struct Overlap {
  int rows = 0;
  int cols = 0;
  long pixels = 0;             // that count in both
  double height_rmse = 0.0;    // after the best plane is taken off the difference, in the unit
  double height_std = 0.0;     // of the second surface there
  double normal_mean = 0.0;    // angle between the normals, radians
  double normal_median = 0.0;  // radians
  bool has_normals = false;
  Grid<float> difference;  // of the heights, first minus second, plane removed
  Mask mask;
  Eigen::Vector2i first_px{0, 0};  // (u, v) of the overlap in the first surface
  Eigen::Vector2i second_px{0, 0};
};

/// Two surfaces side by side: pixel by pixel where they show the same sample, and by their
/// statistics in any case.
struct Comparison {
  std::optional<Overlap> overlap;
  Measurement first;
  Measurement second;
  double spectral_distance_db = 0.0;  // root mean square over the rings
  double spectral_floor_db = 0.0;     // what two surfaces of one spectrum would differ by
};

/// throws  Error if one is in mm and the other in px, or only one has a height
Comparison compare(const Surface& first, const Surface& second);

/// Root mean square over the rings of `a` of 10 log10(a / b), b read between its own rings. Rings
/// of which both have less than a millionth of the strongest ring do not count.
double spectral_distance_db(const Rings& a, const Rings& b);

/// The distance that chance alone makes between the rings of two realisations of one spectrum: root
/// mean square of the standard errors of both, over the rings that count.
double spectral_floor_db(const Rings& a, const Rings& b);

/// Angles between lights that belong together, radians.
std::vector<double> light_errors(const std::vector<Light>& found, const std::vector<Light>& truth);

/// The text of compare.json.
std::string comparison_text(const Comparison& comparison);

}  // namespace hada
