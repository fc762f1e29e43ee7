#pragma once

#include <string_view>

#include <Eigen/Core>

#include "core/light_stack.h"
#include "core/surface.h"

namespace hada {

/// How normals are found from the samples of a pixel.
enum class Estimator {
  least_squares,      // all samples, shadowed and saturated ones too: the paper's, and a baseline
  lit_least_squares,  // the samples that are lit and not saturated
};

/// "least-squares", "lit-least-squares"
std::string_view name_of(Estimator estimator);

/// What the pictures say about orientation and reflectance, pixel by pixel.
struct Orientation {
  NormalMap normals;         // unit length, z > 0
  Image albedo;              // linear, the planes of the pictures
  Mask mask;                 // the stack's mask without the pixels that could not be solved
  Grid<float> normal_sigma;  // radians, root mean square of the two tangent axes
  double noise = 0.0;        // standard deviation of one grey sample, estimated off the residuals
  double relighting_error =
      0.0;                 // root mean square of picture minus prediction over that of picture
  double condition = 0.0;  // of the matrix of light directions; 1 is ideal
};

/// Normals and albedo by least squares: rho = |N^+ I|, n = N^+ I / rho.
///
/// Grey values are the luminance of the pictures with the strength of each light divided out. The
/// sigma is the noise of the samples and of the directions of the lights, through the same N^+. The
/// noise is pooled from the residuals over the neighbourhood of a pixel, so it grows where shadow
/// or sheen break the model; with three lights nothing is left over and 0.005 is taken for it.
///
/// returns  maps of the size of the stack; pixels with fewer than three samples, with lights close
///          to one plane (smallest over largest singular value below 0.02) or with a normal
///          turned away (z < 0.02) leave the mask
/// throws   Error if there are fewer than three lights, or if all lights lie near one plane
///
/// Source: Woodham, Optical Engineering 19 (1980); Kiso et al., section 4.
Orientation least_squares_normals(const LightStack& stack,
                                  Estimator estimator = Estimator::lit_least_squares);

}  // namespace hada
