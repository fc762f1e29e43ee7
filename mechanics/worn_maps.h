#pragma once

#include <vector>

#include "mechanics/wear.h"

namespace hada {

/// Stitches for each mm^2, at each point of a worn knit.
std::vector<double> densities(const WornKnit& knit);

/// How hard the knit presses at each point, in units of the stiffness k of nylon over mm: force
/// over area, which is tension times curvature. A knit whose k is known in N/mm presses with 1000 k
/// times that, in kPa.
///
/// repeat  courses after which yarns repeat: stiff courses press more than soft ones between them,
///         and what is told is the mean over so many
std::vector<double> pressures(const WornKnit& knit, int repeat);

/// The share of light that passes straight yarns of a radius in the direction `view`: the gaps
/// between yarns along courses, times those between yarns along wales, as wide as they look from
/// there. Towards the outline of a body the gaps close.
///
/// along, up  unit directions of the yarns; normal  unit; view  unit, from the body to the eye
double see_through(double wale_mm, double course_mm, double radius_mm, const Eigen::Vector3d& along,
                   const Eigen::Vector3d& up, const Eigen::Vector3d& normal,
                   const Eigen::Vector3d& view);

/// The same for each point, seen straight on.
std::vector<double> transmittances(const WornKnit& knit, double radius_mm);

}  // namespace hada
