#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "capture/load.h"
#include "core/light_stack.h"
#include "core/sphere.h"

namespace hada {

/// What one sphere says of every light.
struct SphereReading {
  Sphere sphere;
  std::vector<Light> lights;  // one for each picture; direction_sigma infinite: not seen
  std::vector<Eigen::Vector2d> highlights_px;  // chrome: the middle of each highlight
  std::vector<Eigen::Vector3d> dark;  // matte: what each picture shows where its light does not
                                      // reach; NaN where all is lit
  double misfit = 0.0;  // matte: root mean square residual over that of the brightness
};

/// Whether a sphere told where a light of its reading is.
inline bool is_seen(const Light& light) {
  return std::isfinite(light.direction_sigma);
}

/// The lights of a set of photographs, and how well they are known.
struct Calibration {
  std::vector<Light> lights;            // one for each picture
  std::vector<SphereReading> readings;  // one for each sphere
  double disagreement = 0.0;       // mean angle between what two spheres say, radians, beyond what
                                   // their places explain
  bool linear = true;              // how the pictures were read
  bool encoding_known = true;      // false: `linear` is an assumption; see settle_encoding
  bool strengths_measured = true;  // false: all 1; see balance_strengths
  bool sample_believed = true;     // false: it is not shaded as a matte one is; see refined_lights
  Eigen::Vector3d ambient_light{0.0, 0.0, 0.0};  // what the sample shows without a lamp
  std::vector<LightErrorMode> errors;            // how the lights may be wrong together
  std::vector<std::string> remarks;              // plain sentences
};

/// Finds the spheres, reads the lights off each, and lets a joint fit agree them with each other
/// and with the sample (`refine_lights.h`).
///
/// Matte: I = b . max(0, n.l) + ambient over the whole lit disc, terminator included. Chrome:
/// l = 2 (n.v) n - v at the area-weighted middle of the highlight. Where the encoding of the
/// pictures is not known, the matte sphere decides between linear and sRGB by its residuals.
///
/// photographs  as loaded (not linearised)
/// throws       Error if no sphere is found, or a picture's light is seen on none of them
Calibration calibrate(const Photographs& photographs);

}  // namespace hada
