#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "core/extent.h"
#include "core/grid.h"
#include "core/surface.h"
#include "synth/wrinkle.h"

/// What shows ridges on a map: the shapes of the histograms of height, slope and curvature.
namespace hada {

/// Three that tell up from down: the skewness of height, how steep the high places are (mean of
/// height times squared slope), the skewness of curvature (asinh of each). Three that tell how
/// frequent extremes are: the kurtosis of height, slope and curvature (the logarithm of a third of
/// each). All are 0 for a Gaussian sheet.
constexpr int ridge_moments = 6;
using RidgeMoments = Eigen::Matrix<double, ridge_moments, 1>;
using RidgeScatter = Eigen::Matrix<double, ridge_moments, ridge_moments>;
enum RidgeMoment {
  height_skew,
  high_slope,
  curvature_skew,
  height_tail,
  slope_tail,
  curvature_tail
};

/// The values of a map that those are moments of, each of mean 0 and variance 1.
struct RidgeValues {
  std::array<std::vector<float>, 2> slopes;  // along x and y
  std::vector<float> heights, curvatures;
};

/// Height, slope and curvature of `height` after `smoothings` passes of a mean over 3 x 3 pixels
/// with weights 1 2 1, where all that they need is inside the mask.
RidgeValues ridge_values(const Grid<float>& height, const Mask& mask, int smoothings);

RidgeMoments moments_of(const RidgeValues& values);

/// How many smoothings leave the floor of `wrinkle` a fifth of the power of the curvature or less.
int smoothings_for(const Wrinkle<>& wrinkle, double pitch);

/// How the moments of one Gaussian sheet with the spectrum of `wrinkle` scatter.
///
/// To first order in 1 / A, for fields with cross correlations r: the covariance of two means of a
/// product of three (or four) fields is the integral over all lags of the permanent of the matrix
/// of their r, divided by A; 6 / A int r^3 for two skewnesses. The two kinds are independent.
///
/// area  of the sheet, in the unit of the spectrum
RidgeScatter gaussian_scatter(const Wrinkle<>& wrinkle, const Extent& extent, double area,
                              int smoothings);

}  // namespace hada
