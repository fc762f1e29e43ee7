#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "core/grid.h"
#include "core/light_stack.h"

namespace hada {

struct FigureOptions {
  double trunk_rad = 0.5 * std::numbers::pi;  // direction up the trunk, counter-clockwise from +x
};

/// The figure of a polished cut of wood: what its fibres do to light.
///
/// With the light at angle delta along the trunk (positive up), L = k_d l_z + k_s cos^n(delta -
/// alpha), alpha the angle by which the fibres dive under the cut. k_d and alpha belong to a pixel,
/// k_s and n to the wood.
struct Figure {
  double specular = 0.0;         // k_s, beside the diffuse albedo
  double sharpness = 0.0;        // n
  double specular_sigma = 0.0;   // standard deviation
  double sharpness_sigma = 0.0;  // standard deviation
  double residual = 0.0;         // root mean square of what is left of the pictures
  Grid<float> diffuse;           // k_d; 0 outside the mask, like the others
  Grid<float> dive_rad;          // alpha
  Grid<float> dive_sigma;        // radians, k_s and n taken for known
  Mask mask;                     // pixels that enough pictures show
};

/// The figure that explains the pictures of `stack` best, by variable projection: for every k_s and
/// n the best k_d and alpha of each pixel.
///
/// A light off the plane of trunk and camera has the delta of its direction's part along the trunk,
/// since a fibre is round. Samples that are saturated or in shadow do not count.
///
/// throws  Error if there are fewer than 6 pictures, their lights hardly differ along the trunk, or
///         the lobe cannot be told from diffuse light (n near 1, or no gloss)
///
/// Source: Kawai, IPSJ Journal 41(3), 2000, equation 4; Golub and Pereyra, SIAM J. Numer. Anal. 10
/// (1973).
Figure figure_of(const LightStack& stack, const FigureOptions& options = {});

}  // namespace hada
