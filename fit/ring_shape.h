#pragma once

#include <vector>

#include <Eigen/Core>

#include "fit/unrolled.h"

namespace hada {

/// A place on the boundary of ring number `ring`; those of one ring in a row follow each other.
struct RingPoint {
  Eigen::Vector2d place;
  int ring;
};

/// The growth frame that makes every ring a circle, and how sure it is. Lengths in the unit of the
/// picture.
struct RingShape {
  GrowthFrame frame;
  std::vector<double> radii;        // effective radius of every ring
  std::vector<double> radii_sigma;  // standard deviation
  Eigen::Vector2d pith_sigma{0.0, 0.0};
  std::vector<Eigen::Vector2d> lobe_sigma;  // of cosine and sine, lobe by lobe
  double scatter = 0.0;        // robust standard deviation of the points about their rings
  double points = 0.0;         // how many there are
  double independent = 0.0;    // how many points that scatter on their own these are worth
  Eigen::MatrixXd covariance;  // of pith x, y and cosine, sine of each lobe
};

/// By how much the Bayesian information criterion prefers `richer`, a fit to the same points with
/// more lobes; negative if the lobes do not pay.
double gain_of(const RingShape& richer, const RingShape& plainer);

/// How the points scatter about rings that a frame can make.
enum class Scatter {
  even,      // the same everywhere: what is left is noise of the picture
  relative,  // in proportion to the radius: what is left is shape that the lobes cannot follow
};

/// Pith, lobes and radii by least squares over `points` with a Cauchy loss.
///
/// start   pith and lobes to start from; which lobes there are is kept
/// rings   how many; every one has at least one point
RingShape fitted_shape(const std::vector<RingPoint>& points, int rings, const GrowthFrame& start,
                       Scatter scatter = Scatter::even);

}  // namespace hada
