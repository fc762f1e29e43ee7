#pragma once

#include <optional>
#include <vector>

#include "capture/calibrate.h"
#include "capture/load.h"
#include "core/sphere.h"

namespace hada {

/// A light seen in a mirror sphere.
struct Highlight {
  Eigen::Vector2d center_px{0.0, 0.0};                   // area-weighted middle
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // of the light
  double width = 0.0;       // root mean square angle of the light about its middle, radians
  bool clipped = false;     // holds a saturated pixel
  double peak = 0.0;        // largest value in it
  double prominence = 0.0;  // peak over the brightness of the rest of the inner disc
};

/// The highlight of one picture: the brightest compact spot in the part of the disc that mirrors
/// what is above the table (within sin 45 degrees of the radius), if there is one.
///
/// The middle is taken over reflected directions, each weighted by brightness and by the solid
/// angle that its pixel reflects, so that an extended light is not pulled towards the rim.
std::optional<Highlight> highlight(const Grid<float>& grey, const Mask& saturated,
                                   const Camera& camera, const Sphere& sphere);

/// Every light as a chrome sphere shows it. The strengths are all 1: a highlight clips, or is
/// smaller than a pixel, and says nothing of them.
SphereReading read_chrome_sphere(const Photographs& linear, const Sphere& sphere);

}  // namespace hada
