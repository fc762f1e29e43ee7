#pragma once

#include <limits>
#include <string>

#include <Eigen/Core>

#include "core/surface.h"
#include "fit/fit.h"
#include "synth/wrinkle.h"

namespace hada {

/// How far a sheet departs from the Gaussian one of its spectrum, and what ridges make of that.
struct RidgeEvidence {
  /// How far two histograms of unit variance lie apart: the mean distance of their quantiles.
  struct Histograms {
    double height = std::numeric_limits<double>::quiet_NaN();
    double slope = height, curvature = height;  // NaN where nothing was compared
  };
  double departure =
      0.0;            // chi-square of six moments of height, slope and curvature, without ridges
  double left = 0.0;  // the same with the ridges that were found
  Histograms gaussian, ridged;  // between the sheet and sheets made without and with ridges

  double explained() const { return departure > 0.0 ? 1.0 - left / departure : 0.0; }
};

/// What a map has beyond its spectrum.
struct RidgeFit {
  Eigen::Vector3d value = Eigen::Vector3d::Zero();  // skew, tail, sharpness
  Eigen::Vector3d sigma = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  RidgeEvidence evidence{};
};

/// The ridges that lie over the noise functions of `spectrum` on the map `height`.
///
/// The skewness of height and curvature and the kurtosis of height, slope and curvature are
/// compared with those of sheets made from the spectrum with ridges (the method of simulated
/// moments). Their sigma carries over the scatter of the moments from sheet to sheet, that of the
/// finite number of sheets, and what the spectrum is not known to.
///
/// height    in the unit of `extent`
/// spectrum  of the map, with its covariance; an empty one stands for a spectrum that is known
/// throws    Error if fewer than 1000 pixels are left once noise is smoothed away
///
/// Source: McFadden, Econometrica 57 (1989); Gourieroux, Monfort, Renault, Journal of Applied
/// Econometrics 8 (1993): weights that are not optimal, the factor 1 + 1 / sheets.
RidgeFit fit_ridges(const Grid<float>& height, const Mask& mask, const Fit<Wrinkle<>>& spectrum,
                    const Extent& extent, const FitProgress& progress = {});

/// What those were, in a sentence for a person.
std::string told(const RidgeFit& ridges);

}  // namespace hada
