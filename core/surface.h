#pragma once

#include <string>

#include <Eigen/Core>

#include "core/extent.h"
#include "core/grid.h"
#include "core/image.h"

namespace hada {

/// Unit vectors in the frame of `Extent`, z > 0.
using NormalMap = Grid<Eigen::Vector3f>;

/// What is there: height, albedo, normals and mask on one lattice, and how well each is known.
///
/// Any map may be empty: a photograph is a Surface with an albedo and no height, a height map has
/// no albedo. Maps that are present have the size of `extent`; outside the mask they have no
/// meaning.
struct Surface {
  Extent extent;
  Mask mask;                 // never empty
  Grid<float> height;        // in extent.unit, zero-mean inside the mask
  NormalMap normals;         // unit length, z > 0
  Image albedo;              // linear, one or three planes
  Grid<float> normal_sigma;  // standard deviation of the normal, radians along each tangent axis
  Grid<float> height_sigma;  // standard deviation of the height, in extent.unit
  std::string levelling = "offset";  // what was removed from the height: offset, plane, quadratic;
                                     // or prior: what its long waves were taken from
  double levelling_cutoff = 0.0;     // of a prior: the wavelength from which on, in extent.unit
  Eigen::Vector2i offset_px{0, 0};   // (u, v) of the first pixel in the pictures this was made from

  bool has_height() const { return !height.empty(); }
};

/// A mask in which every pixel of `extent` counts.
inline Mask full_mask(const Extent& extent) {
  return Mask(extent.rows, extent.cols, 1);
}

/// Normals of a height map by central differences, one-sided at the border of the mask.
///
/// height   in the unit of `pitch`; pixels outside `mask` are not read
/// returns  unit vectors (-dz/dx, -dz/dy, 1) / norm; (0, 0, 1) outside the mask
NormalMap normals_of(const Grid<float>& height, const Mask& mask, double pitch);

}  // namespace hada
