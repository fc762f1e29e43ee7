#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/camera.h"
#include "core/grid.h"
#include "core/image.h"

namespace hada {

/// One light, as one picture knows it.
struct Light {
  std::string image;                                     // the name of its picture
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit, from the sample to the light
  Eigen::Vector3d strength = Eigen::Vector3d::Ones();    // red, green, blue; mean 1 over the lights
  double direction_sigma = 0.0;             // radians, along each tangent axis; 0: given
  std::optional<Eigen::Vector3d> position;  // of a near light, in extent.unit
};

/// Direction times strength (one channel) of the light that arrives at `point`.
///
/// A near light falls off with the square of its distance and has its nominal strength at the
/// origin of the frame; a distant one is the same everywhere.
inline Eigen::Vector3d arriving(const Light& light, int channel, const Eigen::Vector3d& point) {
  const double strength = light.strength[channel];
  if (!light.position) return strength * light.direction;
  const Eigen::Vector3d way = *light.position - point;
  return strength * light.position->squaredNorm() / way.squaredNorm() * way.normalized();
}

/// What became of the light of one picture at one pixel.
///
/// Before the shape is known a dark sample is `shadowed` and no more; afterwards it can be said
/// why.
enum class Sample : std::uint8_t {
  lit,
  shadowed,         // too dark to say anything
  saturated,        // brighter than the file could hold
  attached_shadow,  // the surface looks away from the light: n.l <= 0
  cast_shadow,      // it looks at the light, but much less arrives than should
  highlight,        // much more comes back than a matte surface sends
};

/// What the camera saw: linear pictures, one light each, and which samples can be believed.
///
/// Dark and ambient removed, one size, values in [0, 1] where 1 is the largest the file could hold.
struct LightStack {
  Camera camera;                      // its extent is the extent of the pictures
  std::vector<Image> images;          // all with one or all with three planes
  std::vector<Light> lights;          // one for each image
  std::vector<Grid<Sample>> samples;  // one for each image
  Mask mask;                          // the sample (not the spheres, not the table)

  const Extent& extent() const { return camera.extent; }
};

}  // namespace hada
