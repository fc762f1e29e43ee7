#pragma once

#include <string>
#include <vector>

#include "capture/load.h"
#include "core/sphere.h"

namespace hada {

/// The reference spheres in the frame, and what looked like one and is not.
struct FoundSpheres {
  std::vector<Sphere> spheres;        // from left to right
  std::vector<std::string> rejected;  // "circle at (412, 96), radius 31 px: cut off by the frame"
};

/// Finds every matte and chrome sphere that is wholly in the pictures, with sub-pixel outlines.
///
/// Boxes in the manifest are hints of where to look; without them the whole frame is searched. A
/// circle counts as a sphere only if its inside behaves like one: shading that follows the normals
/// of a sphere in every picture, or one compact highlight that wanders from picture to picture.
///
/// throws  Error if a hinted box holds no sphere, or the sphere in it is cut off by the frame
FoundSpheres find_spheres(const Photographs& photographs);

}  // namespace hada
