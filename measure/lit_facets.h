#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/light_stack.h"
#include "measure/facets.h"

namespace hada {

/// How facets of one paper lie, as all pictures of them say together.
struct LitFacets {
  std::vector<Eigen::Vector2d> slopes;  // of the facets
  Eigen::MatrixXd covariance;           // of all slopes, x before y, facet by facet
  std::vector<double> turned;           // of the lights: how far each was corrected, radians
  int dark_facet = -1;  // one that is lit without shadows in less than three pictures: then nothing
                        // of the above is known
};

struct LitFacetOptions {
  double light_sigma_deg = 1.0;   // of lights of which nobody says how well they are known
  double strength_sigma = 0.005;  // of each light, relative
  double albedo_sigma = 0.02;     // by which facets of one paper differ, relative
};

/// Corrects lights by the sheet itself: a plane is equally bright everywhere, and what lights that
/// are a little wrong leave unexplained in the brightness of all facets tells how they are wrong.
///
/// Unknown are the normal times albedo of each facet and the errors of the lights, within what is
/// said of them (`light_errors`, `direction_sigma`); found by Gauss-Newton on the mean brightness
/// of each facet in each picture, far from creases.
///
/// surface  that the facets were found on; its offset says where it lies in the pictures
LitFacets lit_facets(const Facets& facets, const Surface& surface, const LightStack& stack,
                     const LitFacetOptions& options = {});

/// The angle between two planes, radians, and its sigma from the covariance of all slopes.
double fold_between(const Eigen::Vector2d& one, const Eigen::Vector2d& two);
double fold_sigma(const LitFacets& lit, int first, int second);

}  // namespace hada
