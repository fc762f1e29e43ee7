#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/light_stack.h"
#include "core/surface.h"
#include "reconstruct/bounce.h"
#include "reconstruct/estimator.h"
#include "reconstruct/shared_terms.h"

namespace hada {

struct NormalOptions {
  Estimator estimator = default_estimator;
  const Grid<float>* height = nullptr;  // of the points, in extent.unit, for near lights; none: 0
  const Bounce* bounce = nullptr;       // what `adaptive` may take off; none: nothing
  bool uncertainty = true;              // whether the maps and numbers marked (u) are made
};

/// What the pictures say about orientation and reflectance, pixel by pixel.
struct Orientation {
  NormalMap normals;           // unit length, z > 0
  Image albedo;                // linear, the planes of the pictures
  Mask mask;                   // the stack's mask without the pixels that could not be solved
  Grid<float> rho;             // the albedo in grey, as the normals were found with
  SharedTerms terms;           // what was taken off all pixels, all 0 but for `adaptive`
  double condition = 0.0;      // of the matrix of light directions; 1 is ideal
  double untold_bounce = 0.0;  // as in `NormalPlan`; no sigma knows of it

  Grid<float> normal_sigma;       // (u) radians, root mean square of the two tangent axes
  Grid<float> albedo_sigma;       // (u) of `rho`
  Grid<std::uint8_t> inliers;     // (u) samples that the estimator believed, up to 255
  double noise = 0.0;             // (u) standard deviation of one grey sample, off the residuals
  double relighting_error = 0.0;  // (u) rms of picture minus prediction over that of the picture,
                                  // over the samples that were believed
  double left_out_error = 0.0;  // (u) the same over all lit samples, each against the fit to others
  std::vector<double> light_errors;  // (u) left_out_error of each light
};

/// Normals and albedo from pictures under known lights: I = rho s max(0, n.l).
///
/// The grey value of a sample is its luminance with the strength of the light divided out;
/// `biweight` and `adaptive` take the mean of the channels, which keeps more of the light. The
/// albedo of a channel is fitted to that channel with the normal and the weights found.
///
/// The sigma is the noise of the samples and of the directions of the lights, through the same
/// equations. The noise is pooled from the residuals over the neighbourhood of a pixel, so it grows
/// where the model fails; with three lights nothing is left over and 0.005 is taken for it.
///
/// returns  maps of the size of the stack; pixels with fewer than three samples, with lights close
///          to one plane (smallest over largest singular value below 0.02) or with a normal
///          turned away (z < 0.02) leave the mask
/// throws   Error if there are fewer than three lights, or if all lights lie near one plane
///
/// Sources: Woodham, Optical Engineering 19 (1980); Kiso et al., section 4; those of the
/// estimators.
Orientation solve_normals(const LightStack& stack, const NormalOptions& options = {});

}  // namespace hada
