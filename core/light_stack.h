#pragma once

#include <cmath>
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

/// What arrives at `point` from a lamp of strength 1: towards the lamp, as long as the irradiance.
///
/// The lamp lies in the unit `direction` from the origin of the frame, 1 / `inverse_distance` away
/// (0: infinitely far). Light falls off with the square of the distance and is 1 at the origin:
/// with P = direction / inverse_distance, |P|^2 (P - x) / |P - x|^3. T is double or a Jet.
template <class T>
Eigen::Matrix<T, 3, 1> arriving(const Eigen::Matrix<T, 3, 1>& direction, const T& inverse_distance,
                                const Eigen::Matrix<T, 3, 1>& point) {
  using std::sqrt;
  const Eigen::Matrix<T, 3, 1> way = direction - inverse_distance * point;
  const T square = way.squaredNorm();
  return way / (square * sqrt(square));
}

/// Direction times strength (one channel) of the light that arrives at `point`.
inline Eigen::Vector3d arriving(const Light& light, int channel, const Eigen::Vector3d& point) {
  if (!light.position) return light.strength[channel] * light.direction;
  const double distance = light.position->norm();
  const Eigen::Vector3d direction = *light.position / distance;
  return light.strength[channel] * arriving<double>(direction, 1.0 / distance, point);
}

/// One way in which all lights may be wrong together: what one standard deviation of it adds to
/// direction times strength of each, as it arrives at the sample. Modes are independent of each
/// other.
using LightErrorMode = std::vector<Eigen::Vector3d>;

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
  Camera camera;                             // its extent is the extent of the pictures
  std::vector<Image> images;                 // all with one or all with three planes
  std::vector<Light> lights;                 // one for each image
  std::vector<LightErrorMode> light_errors;  // empty: each direction_sigma stands for itself
  std::vector<Grid<Sample>> samples;         // one for each image
  Mask mask;                                 // the sample (not the spheres, not the table)

  const Extent& extent() const { return camera.extent; }
};

}  // namespace hada
