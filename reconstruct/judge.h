#pragma once

#include <vector>

#include "reconstruct/tile.h"

namespace hada {

/// How wrong the lights may be.
struct LightDoubt {
  std::vector<float> tilt_squared;  // variance of each light's direction, per tangent axis
  // Ways in which all lights are wrong together: x, y, z for each light, over its strength, mode by
  // mode. Empty: each tilts for itself.
  std::vector<float> modes;
};

/// How sure the answers of a tile are: one value for each pixel.
struct Judgement {
  std::vector<float> squares;     // weighted squared residuals, less what the lights explain
  std::vector<float> freedom;     // sum of the weights minus the three unknowns
  std::vector<float> noise_gain;  // variance of the normal, per axis, for a sample variance of 1
  std::vector<float> light_variance;  // of the normal, per axis, that errors of the lights bring
  std::vector<float> albedo_gain;     // relative variance of the albedo, for a sample variance of 1
  std::vector<float> inliers;         // samples that count by half at least
  // Sums of squares for each light over the pixels of `inside`:
  std::vector<double> picture;       // of the samples
  std::vector<double> used;          // residuals, weighted
  std::vector<double> used_picture;  // the samples, weighted likewise
  std::vector<double> left_out;      // residuals of each sample against the fit to all others

  std::vector<float> scratch;  // four vectors for each light
  std::vector<float> gains;    // three vectors for each light

  Judgement(int lights, int most_pixels);
};

/// Judges what an estimator left in `tile`; `inside` says which of its pixels count.
///
/// With A = sum w l l^T and g = A^-1 l, a light turned by dl changes its sample by rho n.dl, which
/// w g carries on to the normal; and the fit without sample k misses it by r / (1 - w g.l), the
/// predicted residual (D. M. Allen, Technometrics 16, 1974), weights held.
///
/// Lights that are wrong together, by e_k each, move rho n by sum w g (rho n.e_k): a sphere whose
/// outline is off turns them all and the surface with them, where independent tilts would cancel.
void judge(const Tile& tile, const LightDoubt& doubt, const std::vector<float>& inside,
           Judgement& judgement);

}  // namespace hada
