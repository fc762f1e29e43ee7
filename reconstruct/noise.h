#pragma once

#include "core/grid.h"

namespace hada {

/// What least squares left over at each pixel; 0 and 0 where nothing was solved.
struct Residuals {
  Grid<float> squares;  // sum of squared residuals, less what other sources of error explain
  Grid<float> freedom;  // degrees of freedom: lit samples minus three
};

/// The standard deviation of a sample where the residuals cannot tell (three lights and no more):
/// half a per cent of the largest value, what a plain 8-bit photograph has.
inline constexpr double prior_noise = 0.005;

/// Residuals are pooled over the square of this many pixels to each side.
inline constexpr int pool_radius_px = 4;

/// What residuals do not show: no surface is Lambertian beyond this share of its albedo, and no two
/// pictures see the same point in a pixel to more than this (standard deviation along an axis).
inline constexpr float unexplained_share = 0.0005f;
inline constexpr float place_sigma_px = 0.06f;

/// The median of chi-squared over its degrees of freedom (Wilson and Hilferty 1931).
double median_of_chi_squared(double freedom);

/// The typical standard deviation of one sample: off the median, so that pixels at which the model
/// fails do not count. `prior_noise` where no pixel has a degree of freedom.
double typical_noise(const Residuals& residuals);

/// The variance of one sample at each pixel: residuals pooled over its neighbourhood, so that it is
/// large where shadow or sheen break the model, and drawn to `noise` where there are few of them.
Grid<float> local_variance(const Residuals& residuals, double noise);

}  // namespace hada
