#pragma once

#include <vector>

#include <Eigen/Core>

#include "capture/sphere_geometry.h"
#include "core/camera.h"
#include "core/grid.h"
#include "core/sphere.h"

namespace hada {

/// The light that everything else in the pictures throws onto points of a matte sphere.
///
/// A matte patch of the sheet or table with the value I sends I cos / (pi r^2) per area towards a
/// point at the distance r, whatever its albedo: what the camera sees of it is all that matters.
/// The patches are taken to lie in the plane z = 0 and to face up; spheres are left out.
///
/// greys    the pictures, linear
/// spheres  all spheres in the pictures
/// points   on one of them
/// returns  for each picture, for each point: its value if the sphere were perfectly white
///
/// Source: the form factor of Goral, Torrance, Greenberg, Battaile, Computer Graphics 18, 3 (1984).
std::vector<std::vector<double>> thrown_light(const std::vector<Grid<float>>& greys,
                                              const Camera& camera,
                                              const std::vector<Sphere>& spheres,
                                              const std::vector<Hit<double>>& points);

}  // namespace hada
